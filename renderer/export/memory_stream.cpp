#include "renderer/export/memory_stream.h"

#include "core/base/error.h"

#include <cstdlib>

namespace limner {

MemoryStream::MemoryStream() : stream_(::open_memstream(&bytes_, &size_)) {
    if (stream_ == nullptr) {
        throw Error(ErrorKind::noResources, {"not enough memory for a picture", "", "", "close other programs"});
    }
}

MemoryStream::~MemoryStream() {
    std::fclose(stream_);
    std::free(bytes_);
}

std::span<const std::byte> MemoryStream::bytes() const {
    std::fflush(stream_);
    return {reinterpret_cast<const std::byte*>(bytes_), size_};
}

} // namespace limner
