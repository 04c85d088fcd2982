#include "core/style/style_library.h"

#include "core/base/error.h"
#include "core/style/find_style.h"
#include "core/style/style_files.h"
#include "core/style/texture_tile.h"
#include "support/small_disk.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace limner {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Style styleNamed(const std::string& name, float grey = 0.5F) {
    Style style;
    style.card.name = name;
    style.sphere = std::make_shared<const LitSphere>(16, std::vector<Rgba>(256, Rgba{grey, grey, grey, 1}));
    return style;
}

class StyleLibraryTest : public ::testing::Test {
  protected:
    StyleLibraryTest()
        : base_(fs::temp_directory_path() / ("limner-library-" + std::to_string(::getpid()))),
          library_(base_ / "deep" / "styles") {
        fs::remove_all(base_);
        fs::create_directories(base_);
    }
    ~StyleLibraryTest() override {
        std::error_code ignored;
        fs::permissions(library_.folder(), fs::perms::owner_all, ignored);
        fs::remove_all(base_);
    }

    [[nodiscard]] fs::path file(const std::string& name) const { return library_.folder() / name; }
    void write(const std::string& name, const std::string& text) const {
        fs::create_directories(library_.folder());
        std::ofstream(file(name), std::ios::binary) << text;
    }
    /// Every name below the folder.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(base_)) {
            names.push_back(entry.path().lexically_relative(base_).string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    [[nodiscard]] std::vector<std::string> ids() const {
        std::vector<std::string> ids;
        for (const StyleCard& card : library_.list().cards) {
            ids.push_back(card.id);
        }
        return ids;
    }
    /// The message, which is one line, of what is thrown with that kind.
    template <class Work>
    static std::string failure(ErrorKind kind, const Work& work) {
        try {
            work();
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), kind) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return error.what();
        }
        ADD_FAILURE() << "nothing was thrown";
        return "";
    }

    fs::path base_;
    StyleLibrary library_;
};

// ---- adding and reading

TEST_F(StyleLibraryTest, WhatIsAddedComesBack) {
    Style style = styleNamed("Dürer's ochre", 0.25F);
    style.card.tags = {"warm", "gouache"};
    style.card.origin = "lion.png, circle 10,20,5";
    style.card.credit = "A. Dürer";
    style.card.licence = "public domain";
    std::vector<Rgba> factors(256, Rgba{0.5F, 1, 1.5F, 1});
    style.texture = std::make_shared<const TextureTile>(16, factors);
    const StyleCard card = library_.add(style);
    EXPECT_EQ(card.id, "durer-s-ochre");
    EXPECT_EQ(card.name, "Dürer's ochre");
    const Style again = StyleLibrary(library_.folder()).load(card.id);
    EXPECT_EQ(again.card.name, style.card.name);
    EXPECT_EQ(again.card.tags, style.card.tags);
    EXPECT_EQ(again.card.origin, style.card.origin);
    EXPECT_EQ(again.card.credit, style.card.credit);
    EXPECT_EQ(again.card.licence, style.card.licence);
    EXPECT_EQ(again.file, file("durer-s-ochre.png").string());
    EXPECT_NEAR(again.sphere->mean().r, 0.25, 1.0 / 65535);
    ASSERT_NE(again.texture, nullptr);
    EXPECT_NEAR(again.texture->pixels()[0].b, 1.5, 1e-4);
    EXPECT_EQ(ids(), std::vector<std::string>{"durer-s-ochre"});
    EXPECT_TRUE(library_.list().problems.empty());
}

TEST_F(StyleLibraryTest, TakenNamesAndIdsGetNumbers) {
    EXPECT_EQ(library_.add(styleNamed("Ochre")).id, "ochre");
    const StyleCard second = library_.add(styleNamed("Ochre"));
    EXPECT_EQ(second.id, "ochre-2");
    EXPECT_EQ(second.name, "Ochre 2");
    EXPECT_EQ(library_.add(styleNamed("ochre!")).id, "ochre-3");
    EXPECT_EQ(library_.add(styleNamed("象牙")).id, "style");
    EXPECT_EQ(library_.add(styleNamed("牙")).id, "style-2");
    const StyleCard& bundled = bundledStyleCards().front();
    const StyleCard own = library_.add(styleNamed(bundled.name));
    EXPECT_NE(own.id, bundled.id);
    EXPECT_EQ(own.name, bundled.name + " 2");
    EXPECT_EQ(library_.list().cards.size(), 6U);
}

TEST_F(StyleLibraryTest, NoIdLeadsOutOfTheFolder) {
    Style style = styleNamed("x");
    for (const std::string id : {"../x", "/etc/x", "..", ".", "a/../../b", ".hidden", "", "removed", "a\nb"}) {
        style.card.id = id;
        const StyleCard card = library_.add(style);
        EXPECT_EQ(fs::path(library_.load(card.id).file).parent_path(), library_.folder());
        if (id != card.id) {
            EXPECT_THROW(static_cast<void>(library_.load(id)), Error) << id;
            EXPECT_THROW(library_.remove(id), Error) << id;
        }
        StyleCard changed = card;
        changed.id = "../" + card.id;
        EXPECT_THROW(library_.change(changed), Error);
    }
    for (const std::string& name : files()) {
        EXPECT_TRUE(name == "deep" || name.rfind("deep/styles", 0) == 0) << name;
    }
}

TEST_F(StyleLibraryTest, AStyleCalledTextureIsNoTexture) {
    EXPECT_EQ(library_.add(styleNamed("Paper")).id, "paper");
    const StyleCard card = library_.add(styleNamed("Paper texture"));
    EXPECT_EQ(card.id, "paper-texture-style");
    EXPECT_EQ(library_.load("paper").texture, nullptr);
    EXPECT_EQ(library_.list().cards.size(), 2U);
}

TEST_F(StyleLibraryTest, ChangesKeepWhatOthersWroteIntoTheCard) {
    StyleCard card = library_.add(styleNamed("Ochre"));
    auto json = nlohmann::json::parse(textOf(file("ochre.json")));
    json["maker"] = {{"program", "another"}};
    write("ochre.json", json.dump());
    card.name = "Burnt\nochre";
    card.licence = "CC BY 4.0";
    library_.change(card);
    const auto changed = nlohmann::json::parse(textOf(file("ochre.json")));
    EXPECT_EQ(changed.at("maker").at("program"), "another");
    EXPECT_EQ(changed.at("name"), "Burnt ochre");
    EXPECT_EQ(library_.load("ochre").card.licence, "CC BY 4.0");
    write("ochre.json", "{ broken");
    EXPECT_NE(failure(ErrorKind::badInput, [&] { library_.change(card); }).find("ochre.json"), std::string::npos);
    EXPECT_EQ(textOf(file("ochre.json")), "{ broken") << "what cannot be read is not written over";
}

// ---- a folder that others write to as well

TEST_F(StyleLibraryTest, WhatCannotBeUsedIsSaidAndTheRestIsListed) {
    library_.add(styleNamed("Good"));
    library_.add(styleNamed("Broken card"));
    library_.add(styleNamed("Cut short"));
    write("broken-card.json", "{ \"name\": ");
    write("cut-short.png", textOf(file("cut-short.png")).substr(0, 20));
    write("not-a-picture.png", "words");
    write("lonely.json", "{}");
    write("photo.jpg", "x");
    write(".hidden", "x");
    write(".favourites.json", "{");
    fs::create_directories(file("folder.png"));
    fs::create_symlink("nowhere", file("dangling.png"));
    fs::copy_file(file("good.png"), file("By hand.png"));
    const StyleLibrary::Listing listing = library_.list();
    EXPECT_EQ(ids(), (std::vector<std::string>{"By hand", "good"}));
    const std::vector<std::string> wanted{"broken-card", "cut-short",  "not-a-picture", "lonely",
                                          "photo.jpg",   "folder.png", "dangling",      "favourites"};
    EXPECT_EQ(listing.problems.size(), wanted.size());
    for (const std::string& word : wanted) {
        EXPECT_TRUE(std::any_of(listing.problems.begin(), listing.problems.end(), [&](const std::string& line) {
            return line.find(word) != std::string::npos;
        })) << word;
    }
    for (const std::string& line : listing.problems) {
        EXPECT_EQ(line.find('\n'), std::string::npos);
    }
    EXPECT_EQ(library_.load("By hand").card.id, "By hand");
    failure(ErrorKind::badInput, [&] { static_cast<void>(library_.load("broken-card")); });
    failure(ErrorKind::badInput, [&] { static_cast<void>(library_.load("cut-short")); });
    failure(ErrorKind::badInput, [&] { static_cast<void>(library_.load("none")); });
    library_.remove("cut-short");
    EXPECT_EQ(library_.list().problems.size(), wanted.size() - 1) << "a broken style can be removed";
}

TEST_F(StyleLibraryTest, ACardsIdIsItsFilesName) {
    library_.add(styleNamed("Good"));
    fs::rename(file("good.png"), file("other.png"));
    fs::rename(file("good.json"), file("other.json"));
    EXPECT_EQ(ids(), std::vector<std::string>{"other"});
    EXPECT_EQ(library_.load("other").card.id, "other");
    EXPECT_EQ(library_.load("other").card.name, "Good");
}

TEST_F(StyleLibraryTest, ManyWritersLoseNothing) {
    constexpr int kEach = 8;
    std::vector<std::thread> writers;
    for (int i = 0; i < 4; ++i) {
        writers.emplace_back([this] {
            for (int k = 0; k < kEach; ++k) {
                StyleLibrary(library_.folder()).add(styleNamed("Ochre"));
                StyleLibrary(library_.folder()).setFavourite("bundled:" + std::to_string(k), true);
            }
        });
    }
    for (std::thread& writer : writers) {
        writer.join();
    }
    EXPECT_EQ(library_.list().cards.size(), 4U * kEach);
    EXPECT_EQ(library_.favourites().size(), std::size_t{kEach});
    EXPECT_TRUE(library_.list().problems.empty());
}

// ---- removing and bringing back

TEST_F(StyleLibraryTest, RemovedStylesComeBackWhole) {
    Style style = styleNamed("Ochre", 0.25F);
    style.texture = std::make_shared<const TextureTile>(16, std::vector<Rgba>(256, Rgba{1, 1, 1, 1}));
    library_.add(style);
    const std::vector<std::string> before = files();
    library_.remove("ochre");
    EXPECT_TRUE(ids().empty());
    EXPECT_TRUE(library_.list().problems.empty());
    EXPECT_EQ(library_.restore("ochre").id, "ochre");
    EXPECT_NE(library_.load("ochre").texture, nullptr);
    EXPECT_EQ(library_.load("ochre").card.name, "Ochre");
    failure(ErrorKind::badInput, [&] { library_.restore("ochre"); });
    failure(ErrorKind::badInput, [&] { library_.restore("../ochre"); });
    failure(ErrorKind::badInput, [&] { library_.remove("ochre-2"); });
}

TEST_F(StyleLibraryTest, TheLastRemovedComesBackFirstAndNeverReplacesAnother) {
    library_.add(styleNamed("Ochre", 0.25F));
    library_.remove("ochre");
    EXPECT_EQ(library_.add(styleNamed("Ochre", 0.75F)).id, "ochre") << "what was removed holds no name";
    EXPECT_EQ(library_.restore("ochre").id, "ochre-2");
    EXPECT_NEAR(library_.load("ochre").sphere->mean().r, 0.75, 1e-3);
    EXPECT_NEAR(library_.load("ochre-2").sphere->mean().r, 0.25, 1e-3);
    library_.remove("ochre-2");
    library_.remove("ochre");
    EXPECT_EQ(library_.restore("ochre").id, "ochre");
    EXPECT_NEAR(library_.load("ochre").sphere->mean().r, 0.75, 1e-3);
}

TEST_F(StyleLibraryTest, TwentyRemovalsAreKept) {
    for (int i = 0; i < 22; ++i) {
        library_.add(styleNamed("Ochre " + std::to_string(i)));
        library_.remove("ochre-" + std::to_string(i));
    }
    failure(ErrorKind::badInput, [&] { library_.restore("ochre-0"); });
    failure(ErrorKind::badInput, [&] { library_.restore("ochre-1"); });
    EXPECT_EQ(library_.restore("ochre-2").id, "ochre-2");
    EXPECT_EQ(library_.restore("ochre-21").id, "ochre-21");
}

TEST_F(StyleLibraryTest, FavouritesAreKept) {
    EXPECT_TRUE(library_.favourites().empty());
    library_.setFavourite("nothing", false);
    EXPECT_EQ(files(), std::vector<std::string>{}) << "reading makes no folder";
    library_.setFavourite("ochre", true);
    library_.setFavourite("bundled:ink", true);
    library_.setFavourite("bundled:ink", true);
    EXPECT_EQ(library_.favourites(), (std::set<std::string>{"ochre", "bundled:ink"}));
    library_.setFavourite("bundled:ink", false);
    EXPECT_EQ(library_.favourites(), std::set<std::string>{"ochre"});
    library_.add(styleNamed("Ochre"));
    EXPECT_TRUE(library_.favourites().empty()) << "another style than the one that was marked";
}

// ---- folders that do not play along

TEST_F(StyleLibraryTest, AFolderThatIsAFileIsNamed) {
    fs::create_directories(library_.folder().parent_path());
    std::ofstream(library_.folder()) << "mine";
    EXPECT_TRUE(library_.list().cards.empty());
    ASSERT_EQ(library_.list().problems.size(), 1U);
    EXPECT_NE(library_.list().problems[0].find("styles"), std::string::npos);
    const std::string line = failure(ErrorKind::noResources, [&] { library_.add(styleNamed("x")); });
    EXPECT_NE(line.find(library_.folder().string()), std::string::npos);
    EXPECT_NE(line.find("LIMNER_STYLES"), std::string::npos);
    failure(ErrorKind::noResources, [&] { library_.setFavourite("x", true); });
    EXPECT_EQ(textOf(library_.folder()), "mine");
}

TEST_F(StyleLibraryTest, FullDisksLeaveNothingBehind) {
    library_.add(styleNamed("Ochre"));
    const std::vector<std::string> before = files();
    for (const rlim_t bytes : {0, 10, 60, 100, 150}) {
        const testing::SmallDisk full(bytes);
        const std::string line = failure(ErrorKind::noResources, [&] { library_.add(styleNamed("Ink")); });
        EXPECT_NE(line.find(library_.folder().string()), std::string::npos);
        EXPECT_EQ(files(), before) << bytes;
    }
}

/// Runs in a process that may not do what root may; its exit status.
template <class Work>
int asOrdinaryUser(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        if (::geteuid() == 0 && ::setuid(65534) != 0) { // nobody
            ::_exit(77);
        }
        try {
            ::_exit(work());
        } catch (const std::exception& error) {
            std::cerr << error.what() << '\n';
            ::_exit(78);
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(StyleLibraryTest, ReadOnlyFoldersAreReadAndNamed) {
    library_.add(styleNamed("Ochre"));
    fs::permissions(base_, fs::perms::all);
    constexpr auto kReadable = static_cast<fs::perms>(0555);
    fs::permissions(library_.folder(), kReadable);
    const std::vector<std::string> before = files();
    const auto refused = [this](const auto& change) {
        return asOrdinaryUser([&] {
            try {
                change();
            } catch (const Error& error) {
                const bool named = std::string(error.what()).find(library_.folder().string()) != std::string::npos;
                return error.kind() == ErrorKind::noResources && named ? 3 : 4;
            }
            return 0;
        });
    };
    EXPECT_EQ(refused([&] { library_.add(styleNamed("Ink")); }), 3);
    EXPECT_EQ(refused([&] { library_.remove("ochre"); }), 3);
    EXPECT_EQ(refused([&] { library_.change(library_.list().cards.at(0)); }), 3);
    EXPECT_EQ(refused([&] { library_.setFavourite("ochre", true); }), 3);
    EXPECT_EQ(asOrdinaryUser([&] { return library_.load("ochre").card.name == "Ochre" ? 3 : 4; }), 3);
    EXPECT_EQ(files(), before);
}

TEST_F(StyleLibraryTest, UnreadableFoldersAreAProblemAndNoEnd) {
    library_.add(styleNamed("Ochre"));
    fs::permissions(library_.folder(), fs::perms::none);
    EXPECT_EQ(asOrdinaryUser([&] {
                  const StyleLibrary::Listing listing = library_.list();
                  return listing.cards.empty() && listing.problems.size() >= 1 ? 3 : 4;
              }),
              3);
}

TEST_F(StyleLibraryTest, TheUsersFolderIsWhereTheSystemSays) {
    const auto with = [](const char* own, const char* data, const char* home) {
        for (const auto& [name, value] : {std::pair("LIMNER_STYLES", own), {"XDG_DATA_HOME", data}, {"HOME", home}}) {
            value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
        }
        return StyleLibrary::userFolder();
    };
    const int status = asOrdinaryUser([&] {
        const bool sound = with("/a", "/b", "/c") == "/a" && with("", "/b", "/c") == "/b/limner/styles" &&
                           with(nullptr, "relative", "/c") == "/c/.local/share/limner/styles" &&
                           with(nullptr, nullptr, "/c") == "/c/.local/share/limner/styles" &&
                           with(nullptr, nullptr, nullptr).filename() == "styles";
        return sound ? 3 : 4;
    });
    EXPECT_EQ(status, 3);
}

// ---- by a word

TEST_F(StyleLibraryTest, WordsMeanOnesOwnStylesFirst) {
    const std::string bundled = bundledStyleCards().front().id;
    EXPECT_EQ(findStyle(bundled, library_)->file, "bundled:" + bundled);
    EXPECT_FALSE(findStyle("no-such-style", library_));
    EXPECT_FALSE(findStyle("bundled:no-such-style", library_));
    EXPECT_FALSE(findStyle("../ochre", library_));
    library_.add(styleNamed("Ochre"));
    EXPECT_EQ(findStyle("ochre", library_)->file, file("ochre.png").string());
    EXPECT_EQ(findStyle(file("ochre.png").string(), library_)->card.name, "Ochre");
    fs::copy_file(file("ochre.png"), file(bundled + ".png"));
    EXPECT_EQ(findStyle(bundled, library_)->file, file(bundled + ".png").string());
    EXPECT_EQ(findStyle("bundled:" + bundled, library_)->file, "bundled:" + bundled);
    const std::vector<std::string> known = knownStyleIds(library_);
    EXPECT_EQ(known.size(), bundledStyleCards().size() + 2);
}

// ---- a style's files anywhere

TEST_F(StyleLibraryTest, ACardNeverReplacesAnotherJsonFile) {
    fs::create_directories(library_.folder());
    write("figure.json", R"({"limner": 1, "title": "mine"})");
    failure(ErrorKind::badInput, [&] { writeStyle(styleNamed("x"), file("figure.png")); });
    EXPECT_FALSE(fs::exists(file("figure.png")));
    EXPECT_NE(textOf(file("figure.json")).find("mine"), std::string::npos);
    writeStyle(styleNamed("x"), file("style.png"));
    writeStyle(styleNamed("y"), file("style.png"));
    EXPECT_EQ(loadStyle(file("style.png")).card.name, "y");
}

} // namespace
} // namespace limner
