#include "core/style/square_picture.h"

#include "core/base/error.h"
#include "core/style/picture_rows.h"

#include <new>
#include <span>

namespace limner {
namespace {

namespace fs = std::filesystem;

void checkSize(const PictureRows& rows, const PictureRules& rules) {
    const std::string size = std::to_string(rows.width()) + " x " + std::to_string(rows.height()) + " pixels";
    if (rows.width() != rows.height()) {
        rows.fail(size + " are not square", rules.crop);
    }
    if (rows.width() < rules.widths[0] || rows.width() > rules.widths[1]) {
        rows.fail(size + " are out of range", rules.resize);
    }
}

} // namespace

SquarePicture readSquarePicture(const fs::path& file, const PictureRules& rules) {
    try {
        PictureRows rows(file, {rules.what, rules.formats});
        checkSize(rows, rules);
        SquarePicture picture{rows.width(), {}};
        for (int y = 0; y < rows.height(); y += rows.bandRows()) {
            const std::span<const Rgba> band = rows.read(y);
            picture.pixels.insert(picture.pixels.end(), band.begin(), band.end());
        }
        return picture;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::noResources, {rules.what, file.string(), "out of memory", "use a smaller picture"});
    }
}

void checkSquarePicture(const fs::path& file, const PictureRules& rules) {
    checkSize(PictureRows(file, {rules.what, rules.formats}), rules);
}

} // namespace limner
