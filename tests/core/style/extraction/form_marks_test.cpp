#include "core/base/error.h"
#include "core/project/archive.h"
#include "core/style/extraction/forms.h"
#include "support/hand_written_pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limner {
namespace {

class MarksFiles : public ::testing::Test {
  protected:
    FormMarks load(const std::string& text) const {
        return loadFormMarks(testing::writeBytes(folder_.path() / "marks.json", text));
    }

    std::string refusal(const std::string& text) const {
        try {
            load(text);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            const std::string line = error.what();
            EXPECT_NE(line.find("marks.json"), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
            return line;
        }
        ADD_FAILURE() << text << " was taken";
        return {};
    }

    TemporaryFolder folder_;
};

TEST_F(MarksFiles, AreReadAsTheyAreWritten) {
    const FormMarks marks =
        load(R"({"normals": [{"at": [10, 20.5], "normal": [0.6, -0.8]}, {"at": [1, 2], "normal": [0, 0]}],
        "creases": [{"path": [[1, 2], [3, 4], [5, 6]], "tilt_deg": -45}, {"path": [[0, 0], [9, 9]]}],
        "open": [[[7, 8], [9, 10]]], "depth": 0.5})");
    FormMarks expected;
    expected.normals = {{{10, 20.5}, {0.6, -0.8}}, {{1, 2}, {0, 0}}};
    expected.creases = {{{{1, 2}, {3, 4}, {5, 6}}, -45}, {{{0, 0}, {9, 9}}, 30}};
    expected.open = {{{7, 8}, {9, 10}}};
    expected.depth = 0.5;
    EXPECT_EQ(marks, expected);
    EXPECT_EQ(load("{}"), FormMarks());
}

TEST_F(MarksFiles, NormalsAtTheRimAreRounded) {
    const FormMarks marks = load(R"({"normals": [{"at": [0, 0], "normal": [0.70711, 0.70711]}]})");
    EXPECT_LE(glm::dvec2(marks.normals[0].normal).x, 0.70711);
    EXPECT_LE(std::hypot(marks.normals[0].normal.x, marks.normals[0].normal.y), 1 + 1e-12);
}

TEST_F(MarksFiles, BadOnesAreRefusedWithTheirPlace) {
    EXPECT_NE(refusal(R"({"normals": [{"at": [1, 2], "normal": [0.9, 0.9]}]})").find("/normals/0/normal"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"normals": [{"at": [1], "normal": [0, 0]}]})").find("/normals/0/at"), std::string::npos);
    EXPECT_NE(refusal(R"({"normals": [{"normal": [0, 0]}]})").find("\"at\""), std::string::npos);
    EXPECT_NE(refusal(R"({"depth": 0})").find("/depth"), std::string::npos);
    EXPECT_NE(refusal(R"({"normals": {}})").find("/normals"), std::string::npos);
    EXPECT_NE(refusal(R"({"creases": [{"path": [[1, 2]]}]})").find("/creases/0/path"), std::string::npos);
    EXPECT_NE(refusal(R"({"creases": [{"path": [[1, 2], [3, "4"]]}]})").find("/creases/0/path/1/1"), std::string::npos);
    EXPECT_NE(refusal(R"({"creases": [{"path": [[1, 2], [3, 4]], "tilt_deg": 91}]})").find("tilt_deg"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"open": [5]})").find("/open/0"), std::string::npos);
    EXPECT_NE(refusal(R"({"normal": []})").find("/normal"), std::string::npos);
    refusal("[]");
    refusal("{");
    refusal("");
    refusal(R"({"open": [[[1e999, 0], [1, 1]]]})");
    refusal(std::string(100000, '['));
    EXPECT_THROW(loadFormMarks(folder_.path() / "none.json"), Error);
    EXPECT_THROW(loadFormMarks(folder_.path()), Error);
}

} // namespace
} // namespace limner
