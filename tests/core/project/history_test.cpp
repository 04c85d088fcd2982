#include "core/project/history.h"

#include <gtest/gtest.h>

#include <random>

namespace limner {
namespace {

Figure withTitle(const std::string& title) {
    Figure figure;
    figure.title = title;
    return figure;
}

/// One random change of some kind that the studio makes.
Figure randomlyEdited(Figure figure, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    switch (random() % 6) {
    case 0: figure.camera.heightMm = 1 + 500 * unit(random); break;
    case 1: figure.camera.direction = {unit(random), unit(random), unit(random)}; break;
    case 2: figure.layers.emplace_back().name = std::to_string(random()); break;
    case 3:
        if (!figure.layers.empty())
            figure.layers.erase(figure.layers.begin() + static_cast<long>(random() % figure.layers.size()));
        break;
    case 4:
        if (!figure.layers.empty())
            figure.layers.back().transfer.opacity.emplace_back(unit(random) * 4000 - 1000, unit(random));
        break;
    default: figure.title = std::to_string(unit(random)); break;
    }
    return figure;
}

TEST(History, TenThousandEditsComeBackBitForBit) {
    std::mt19937 random(20);
    const Figure start = withTitle("start");
    History history(start, 20000);
    std::vector<Figure> states{start};
    for (int i = 0; i < 10000; ++i) {
        const Figure edited = randomlyEdited(*history.current(), random);
        const bool changed = !(edited == *history.current());
        EXPECT_EQ(history.apply({edited, "edit", {}, false}), changed);
        if (changed)
            states.push_back(edited);
    }
    const Figure end = *history.current();
    ASSERT_GT(states.size(), 8000U) << "the generator must mostly change something";
    for (std::size_t i = states.size(); i-- > 1;) {
        ASSERT_EQ(*history.current(), states[i]);
        ASSERT_TRUE(history.undo());
    }
    EXPECT_FALSE(history.undo());
    EXPECT_EQ(*history.current(), start);
    while (history.redo()) {
    }
    EXPECT_EQ(*history.current(), end);
}

TEST(History, ADragIsOneStep) {
    History history(withTitle("a"));
    for (const char* title : {"b", "c", "d"})
        history.apply({withTitle(title), "Drag", "drag#1", true});
    EXPECT_EQ(history.current()->title, "d");
    EXPECT_EQ(history.undoLabel(), "Drag");
    history.apply({withTitle("e"), "Drag", "drag#2", false});
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.current()->title, "d");
    ASSERT_TRUE(history.undo());
    EXPECT_EQ(history.current()->title, "a");
    EXPECT_FALSE(history.canUndo());
}

TEST(History, MergingEndsAtUndoAndOnRequest) {
    History history(withTitle("a"));
    history.apply({withTitle("b"), "Drag", "drag", false});
    history.undo();
    history.redo();
    history.apply({withTitle("c"), "Drag", "drag", false});
    EXPECT_EQ(history.position(), 2U);
    history.endMerge();
    history.apply({withTitle("d"), "Drag", "drag", false});
    EXPECT_EQ(history.position(), 3U);
}

TEST(History, EditsWithoutKeyNeverMerge) {
    History history;
    history.apply({withTitle("a"), "One", {}, false});
    history.apply({withTitle("b"), "Two", {}, false});
    EXPECT_EQ(history.position(), 2U);
}

TEST(History, ADragBackToItsStartLeavesNoStep) {
    History history(withTitle("a"));
    const History::StateId before = history.stateId();
    history.apply({withTitle("b"), "Drag", "drag", true});
    EXPECT_NE(history.stateId(), before);
    history.apply({withTitle("a"), "Drag", "drag", true});
    EXPECT_EQ(history.stateId(), before);
    EXPECT_FALSE(history.canUndo());
    EXPECT_FALSE(history.canRedo());
}

TEST(History, StateIdsTellSavedFromChanged) {
    History history(withTitle("a"));
    history.apply({withTitle("b"), "Drag", "drag", true});
    const History::StateId saved = history.stateId();
    history.apply({withTitle("c"), "Drag", "drag", true});
    EXPECT_NE(history.stateId(), saved) << "merging changes the state all the same";
    history.undo();
    history.apply({withTitle("b"), "Again", {}, false});
    EXPECT_NE(history.stateId(), saved) << "ids are never used twice";
}

TEST(History, ANewEditDropsWhatCouldBeRedone) {
    History history(withTitle("a"));
    history.apply({withTitle("b"), "B", {}, false});
    history.undo();
    EXPECT_EQ(history.redoLabel(), "B");
    history.apply({withTitle("c"), "C", {}, false});
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.redoLabel(), "");
}

TEST(History, StaysWithinItsLimit) {
    History history(withTitle("start"), 5);
    for (int i = 0; i < 20; ++i)
        history.apply({withTitle(std::to_string(i)), "edit", {}, false});
    EXPECT_EQ(history.steps().size(), 6U);
    while (history.undo()) {
    }
    EXPECT_EQ(history.current()->title, "14");
}

TEST(History, GoesToAnyKeptStateAndKeepsTheOthers) {
    History history(withTitle("0"));
    for (int i = 1; i <= 5; ++i)
        history.apply({withTitle(std::to_string(i)), "step", "key" + std::to_string(i), false});
    EXPECT_TRUE(history.goTo(1));
    EXPECT_EQ(history.current()->title, "1");
    EXPECT_EQ(history.steps().size(), 6U);
    EXPECT_TRUE(history.goTo(4));
    EXPECT_EQ(history.current()->title, "4");
    EXPECT_FALSE(history.goTo(4)) << "there already";
    EXPECT_FALSE(history.goTo(6)) << "not there";
    EXPECT_EQ(history.position(), 4U);
    history.apply({withTitle("other"), "step", "key4", false});
    EXPECT_EQ(history.position(), 5U) << "who went there has ended the gesture";
    EXPECT_FALSE(history.canRedo());
}

} // namespace
} // namespace limner
