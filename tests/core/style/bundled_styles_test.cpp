#include "core/base/error.h"
#include "core/style/lit_sphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

namespace limner {
namespace {

TEST(BundledStyles, CardsAreCompleteAndSorted) {
    const auto& cards = bundledStyleCards();
    ASSERT_GE(cards.size(), 24U);
    std::set<std::string> ids;
    std::set<std::string> tags;
    for (const StyleCard& card : cards) {
        EXPECT_TRUE(ids.insert(card.id).second) << card.id;
        EXPECT_FALSE(card.name.empty()) << card.id;
        EXPECT_FALSE(card.tags.empty()) << card.id;
        EXPECT_FALSE(card.origin.empty()) << card.id;
        EXPECT_FALSE(card.credit.empty()) << card.id;
        EXPECT_FALSE(card.licence.empty()) << card.id;
        tags.insert(card.tags.begin(), card.tags.end());
    }
    EXPECT_TRUE(
        std::is_sorted(cards.begin(), cards.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
    for (const char* role : {"bone", "skin", "vessel", "muscle", "organ", "outline", "brain", "tooth", "industrial"}) {
        EXPECT_TRUE(tags.contains(role)) << role;
    }
}

TEST(BundledStyles, ThreadsThatAskAtOnceGetOneAndTheSamePicture) {
    std::vector<const Style*> got(8);
    std::vector<std::shared_ptr<const LitSphere>> spheres(got.size());
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < got.size(); ++i) {
            threads.emplace_back([&, i] {
                got[i] = i % 2 == 0 ? findBundledStyle("glass")
                                    : &*std::find_if(bundledStyles().begin(), bundledStyles().end(),
                                                     [](const Style& s) { return s.card.id == "glass"; });
                spheres[i] = got[i]->sphere;
            });
        }
    }
    for (std::size_t i = 0; i < got.size(); ++i) {
        EXPECT_EQ(got[i], got[0]);
        EXPECT_NE(spheres[i], nullptr);
        EXPECT_EQ(spheres[i], spheres[0]);
    }
    EXPECT_EQ(findBundledStyle("no-such-style"), nullptr);
}

TEST(BundledStyles, PicturesClipNothingAndDifferFromEachOther) {
    const auto& styles = bundledStyles();
    for (const Style& style : styles) {
        ASSERT_NE(style.sphere, nullptr) << style.card.id;
        EXPECT_EQ(style.sphere->size(), 512) << style.card.id;
        for (const Rgba& texel : style.sphere->pixels()) {
            // Paper white and ink black in print: neither end is touched.
            ASSERT_GT(std::min({texel.r, texel.g, texel.b}), 0.003F) << style.card.id;
            ASSERT_LT(std::max({texel.r, texel.g, texel.b}), 0.997F) << style.card.id;
        }
    }
    for (std::size_t i = 0; i < styles.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            double sum = 0;
            int count = 0;
            for (double y = -0.95; y < 1; y += 0.1) {
                for (double x = -0.95; x < 1; x += 0.1) {
                    const Rgba a = styles[i].sphere->at(x, y);
                    const Rgba b = styles[j].sphere->at(x, y);
                    sum += std::hypot(a.r - b.r, a.g - b.g, a.b - b.b) + std::abs(a.a - b.a);
                    ++count;
                }
            }
            // 4 % of the range on average: side by side nobody takes one for the other.
            EXPECT_GT(sum / count, 0.04) << styles[i].card.id << " and " << styles[j].card.id;
        }
    }
}

TEST(BundledStyles, ShadedOnesAreLitFromTheUpperLeft) {
    int shaded = 0;
    for (const Style& style : bundledStyles()) {
        const auto& tags = style.card.tags;
        if (std::find(tags.begin(), tags.end(), "shaded") == tags.end()) {
            continue;
        }
        const auto light = [&](double x, double y) {
            const Rgba c = style.sphere->at(x, y);
            return 0.2 * c.r + 0.7 * c.g + 0.1 * c.b;
        };
        EXPECT_GT(light(-0.4, 0.4), light(0.0, 0.0)) << style.card.id;
        EXPECT_GT(light(0.0, 0.0), light(0.55, -0.55)) << style.card.id;
        ++shaded;
    }
    EXPECT_GE(shaded, 12);
}

TEST(BundledStyles, OnlyTheSeeThroughOnesHaveDirectionalOpacity) {
    for (const Style& style : bundledStyles()) {
        const auto& tags = style.card.tags;
        const bool clear = std::find(tags.begin(), tags.end(), "transparent") != tags.end();
        EXPECT_EQ(style.sphere->hasDirectionalOpacity(), clear) << style.card.id;
        if (clear) {
            EXPECT_LT(style.sphere->at(0.1, -0.1).a, 0.25) << style.card.id;
            EXPECT_GT(style.sphere->at(0.7, -0.714).a, 0.75) << style.card.id;
        }
    }
}

} // namespace
} // namespace limner
