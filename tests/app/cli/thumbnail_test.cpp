#include "core/project/project_thumbnail.h"
#include "program_run.h"

#include <OpenImageIO/imageio.h>

namespace limner {
namespace {

using testing::run;

class Thumbnail : public testing::WithScan {
  protected:
    static int edgeOf(const std::string& file) {
        const auto in = OIIO::ImageInput::open(file);
        return in == nullptr ? 0 : std::max(in->spec().width, in->spec().height);
    }
};

TEST_F(Thumbnail, OfAProjectIsWhatItKeepsNoLargerThanAskedFor) {
    ASSERT_EQ(run({"new", scan(), "-o", path("head.limner")}).code, 0);
    const auto small = run({"thumbnail", path("head.limner"), "-o", path("s.png"), "-s", "64", "--json"});
    ASSERT_EQ(small.code, 0) << small.err;
    EXPECT_EQ(small.facts()["kept"], true);
    EXPECT_EQ(edgeOf(path("s.png")), 64);
    ASSERT_EQ(run({"thumbnail", path("head.limner"), "-o", path("l.png"), "-s", "512"}).code, 0);
    EXPECT_EQ(edgeOf(path("l.png")), 256) << "what is kept is not blown up";
}

TEST_F(Thumbnail, OfAScanIsDrawn) {
    const auto drawn = run({"thumbnail", scan(), "-o", path("s.png"), "-s", "48", "--json"});
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(drawn.facts()["kept"], false);
    EXPECT_EQ(edgeOf(path("s.png")), 48);
    EXPECT_EQ(run({"thumbnail", scan(), "-o", path("s.png"), "-s", "4"}).code, 2);
    EXPECT_EQ(run({"thumbnail", path("none.limner"), "-o", path("n.png")}).code, 3);
}

} // namespace
} // namespace limner
