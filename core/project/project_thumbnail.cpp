#include "core/project/project_thumbnail.h"

#include "core/base/error.h"
#include "core/project/archive.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace limner {
namespace {

constexpr int kLongestEdge = 2048; // far beyond what a thumbnail has: a damaged one must not take the memory

[[noreturn]] void fail(const std::filesystem::path& project) {
    throw Error(ErrorKind::badInput, {"cannot read the thumbnail", project.string(), "it is damaged",
                                      "open and save the project in limner-studio"});
}

} // namespace

std::optional<std::string> projectThumbnail(const std::filesystem::path& project, int edge) {
    if (!looksLikeArchive(project)) {
        return std::nullopt;
    }
    const Archive archive(project);
    const ArchiveEntry* entry = archive.find("thumbnail.png");
    if (entry == nullptr) {
        return std::nullopt;
    }
    std::string bytes = archive.read(*entry);
    OIIO::Filesystem::IOMemReader source(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::open("thumbnail.png", nullptr, &source);
    if (input == nullptr || std::max(input->spec().width, input->spec().height) > kLongestEdge) {
        fail(project);
    }
    const OIIO::ImageSpec& spec = input->spec();
    if (std::max(spec.width, spec.height) <= edge) {
        return bytes;
    }
    OIIO::ImageBuf full(OIIO::ImageSpec(spec.width, spec.height, spec.nchannels, OIIO::TypeDesc::FLOAT));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, full.localpixels())) {
        fail(project);
    }
    const double scale = static_cast<double>(edge) / std::max(spec.width, spec.height);
    const OIIO::ROI small(0, std::max(1, static_cast<int>(spec.width * scale)), 0,
                          std::max(1, static_cast<int>(spec.height * scale)), 0, 1, 0, spec.nchannels);
    const OIIO::ImageBuf scaled = OIIO::ImageBufAlgo::resize(full, {}, small);
    std::vector<unsigned char> packed;
    OIIO::Filesystem::IOVecOutput sink(packed);
    OIIO::ImageSpec out(small.width(), small.height(), spec.nchannels, OIIO::TypeDesc::UINT8);
    const auto output = OIIO::ImageOutput::create("png");
    if (output == nullptr || !output->set_ioproxy(&sink) || !output->open("thumbnail.png", out) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, scaled.localpixels()) || !output->close()) {
        fail(project);
    }
    return std::string(packed.begin(), packed.end());
}

} // namespace limner
