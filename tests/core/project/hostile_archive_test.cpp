#include "archive_bytes.h"

#include "core/base/error.h"
#include "core/project/archive.h"
#include "core/project/project.h"

#include <gtest/gtest.h>

#include <fstream>

namespace limner {
namespace {

namespace fs = std::filesystem;
using testing::deflatedEntry;
using testing::RawEntry;
using testing::storedEntry;
using testing::zipBytes;

const std::string kFigureText = R"({"limner": 1, "title": "small"})";

fs::path written(const TemporaryFolder& folder, const std::string& bytes) {
    const fs::path path = folder.path() / "hostile.limner";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

/// Opens bytes as a project; the error's line, or empty where they are accepted.
std::string openError(const std::string& bytes) {
    const TemporaryFolder folder;
    Task task;
    std::string line;
    try {
        openDocument(written(folder, bytes), "", {}, task);
    } catch (const Error& error) {
        line = error.what();
        EXPECT_EQ(error.kind(), ErrorKind::badInput) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "something was written beside it";
    return line;
}

/// A sound figure and one more entry.
std::string with(const RawEntry& entry) { return zipBytes({storedEntry("figure.json", kFigureText), entry}); }

TEST(HostileArchive, ASoundOneIsRead) {
    EXPECT_EQ(openError(zipBytes({storedEntry("figure.json", kFigureText)})), "");
    EXPECT_EQ(openError(zipBytes({deflatedEntry("figure.json", kFigureText), storedEntry("styles/", ""),
                                  storedEntry("styles/a.json", "{}"), storedEntry("later/part.bin", "x")})),
              "");
}

TEST(HostileArchive, NamesThatClimbOrHideAreRefused) {
    const std::string names[] = {"/etc/passwd",
                                 "../evil",
                                 "styles/../../evil",
                                 "styles/..",
                                 "./figure",
                                 "C:/evil",
                                 "styles\\a.png",
                                 "..\\evil",
                                 "a//b",
                                 "a:stream",
                                 "tab\tname",
                                 "line\nname",
                                 "delete\x7f",
                                 "Figure.json",
                                 "FIGURE.JSON",
                                 std::string(300, 'x'),
                                 "",
                                 "styles/./a.png",
                                 "//host/share"};
    for (const std::string& name : names) {
        EXPECT_NE(openError(with(storedEntry(name, "x"))), "") << name;
    }
    EXPECT_NE(openError(with(storedEntry(std::string("styles/a\0.png", 13), "x"))), "");
    EXPECT_NE(openError(with(storedEntry("figure.json", "{}"))), "");
}

TEST(HostileArchive, LinksDevicesLocksAndArchivesInsideAreRefused) {
    for (const std::uint32_t mode : {0120777U, 0020666U, 0060666U, 0010666U, 0140777U}) {
        RawEntry entry = storedEntry("styles/a.png", "/etc/passwd");
        entry.attributes = mode << 16U;
        EXPECT_NE(openError(with(entry)), "") << std::oct << mode;
    }
    RawEntry locked = storedEntry("styles/a.png", "secretsecretsecret");
    locked.flags = 1;
    EXPECT_NE(openError(with(locked)), "");
    RawEntry odd = storedEntry("styles/a.png", "x");
    odd.method = 97;
    EXPECT_NE(openError(with(odd)), "");
    EXPECT_NE(openError(with(storedEntry("inner.zip", "PK"))), "");
    EXPECT_NE(openError(with(storedEntry("deep/inner.LIMNER", "PK"))), "");
}

TEST(HostileArchive, BombsAndLiesAreRefusedBeforeUnpacking) {
    EXPECT_NE(openError(with(deflatedEntry("styles/a.png", std::string(8 << 20, '\0')))).find("would unpack"),
              std::string::npos);
    EXPECT_NE(openError(zipBytes({deflatedEntry("figure.json", std::string(32 << 20, ' '))})), "");
    RawEntry huge = storedEntry("styles/a.png", "x");
    huge.size = 0xfffffff0U;
    EXPECT_NE(openError(with(huge)), "");
    RawEntry longer = deflatedEntry("figure.json", kFigureText + std::string(1000, ' '));
    longer.size = 20;
    EXPECT_NE(openError(zipBytes({longer})), "");
    RawEntry shorter = deflatedEntry("figure.json", kFigureText);
    shorter.size = 5000;
    EXPECT_NE(openError(zipBytes({shorter})), "");
    RawEntry changed = storedEntry("figure.json", kFigureText);
    changed.crc ^= 1U;
    EXPECT_NE(openError(zipBytes({changed})).find("damaged"), std::string::npos);

    std::vector<RawEntry> overlapping = {storedEntry("figure.json", kFigureText),
                                         deflatedEntry("styles/a0.png", std::string(90 << 10, 'a'))};
    for (int i = 1; i < 200; ++i) {
        RawEntry copy = overlapping[1];
        copy.name = "styles/a" + std::to_string(i) + ".png";
        copy.sharedOffset = static_cast<long>(30 + 11 + kFigureText.size());
        overlapping.push_back(copy);
    }
    EXPECT_NE(openError(zipBytes(overlapping)), "");

    std::vector<RawEntry> many = {storedEntry("figure.json", kFigureText)};
    for (int i = 0; i < 10001; ++i) {
        many.push_back(storedEntry("styles/" + std::to_string(i) + ".json", ""));
    }
    EXPECT_NE(openError(zipBytes(many)).find("10000"), std::string::npos);
}

TEST(HostileArchive, WhatIsNoProjectIsRefused) {
    const std::string sound = zipBytes({storedEntry("figure.json", kFigureText)});
    EXPECT_NE(openError(""), "");
    EXPECT_NE(openError("not a zip"), "");
    EXPECT_NE(openError("PK\x03\x04"), "");
    EXPECT_NE(openError(zipBytes({})), "");
    EXPECT_NE(openError(zipBytes({storedEntry("other.txt", "x")})).find("no figure.json"), std::string::npos);
    EXPECT_NE(openError(zipBytes({storedEntry("figure.json", kFigureText)}, 50)), "");
    EXPECT_NE(openError(zipBytes({storedEntry("figure.json", "{\"limner\": 9}")})).find("newer"), std::string::npos);
    EXPECT_NE(openError(zipBytes({storedEntry("figure.json", "[[[[")})), "");
}

TEST(HostileArchive, EveryCutAndEveryChangedByteIsRefusedOrHarmless) {
    const std::string sound =
        zipBytes({deflatedEntry("figure.json", kFigureText), storedEntry("styles/a.json", "{\"id\": \"a\"}")});
    const TemporaryFolder folder;
    Task task;
    int refused = 0;
    const auto check = [&](const std::string& bytes) {
        try {
            const Document document = openDocument(written(folder, bytes), "", {}, task);
            EXPECT_EQ(document.figure.title, "small"); // harmless: nothing that counts was touched
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            ++refused;
        }
    };
    for (std::size_t length = 0; length < sound.size(); ++length) {
        check(sound.substr(0, length));
    }
    EXPECT_EQ(refused, static_cast<int>(sound.size()));
    for (std::size_t i = 0; i < sound.size(); ++i) {
        std::string bytes = sound;
        bytes[i] = static_cast<char>(bytes[i] ^ 0x41);
        check(bytes);
    }
    EXPECT_GT(refused, static_cast<int>(sound.size()) + static_cast<int>(sound.size()) / 3);
}

} // namespace
} // namespace limner
