#pragma once

#include "renderer/export/picture_format.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <string>

namespace limner {

struct PictureHeader {
    PictureFormat format = PictureFormat::png;
    PixelLayout layout;
    glm::ivec2 size{0};
    double dpi = 300;
    int bandRows = 64; ///< rows per call of `writeRows`, but for the last
    std::string name;  ///< for messages
};

/// Encodes a picture, top to bottom, into an open stream. Colour profile and dpi are written where the format carries
/// them. One thread at a time.
class PictureWriter {
  public:
    PictureWriter(const PictureHeader& header, std::FILE* stream);
    ~PictureWriter();
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;

    /// The next `rows` rows in the layout's form. Throws Error(noResources) where the format's library refuses.
    void writeRows(std::span<const std::byte> bytes, int rows);
    /// Completes the file; nothing can be written after it.
    void finish();

  private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

} // namespace limner
