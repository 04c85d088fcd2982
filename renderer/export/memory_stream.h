#pragma once

#include <cstddef>
#include <cstdio>
#include <span>

namespace limner {

/// A stream that grows in memory.
class MemoryStream {
  public:
    /// Throws Error(noResources).
    MemoryStream();
    ~MemoryStream();
    MemoryStream(const MemoryStream&) = delete;
    MemoryStream& operator=(const MemoryStream&) = delete;

    [[nodiscard]] std::FILE* stream() const { return stream_; }
    /// Everything written so far, until more is.
    [[nodiscard]] std::span<const std::byte> bytes() const;

  private:
    char* bytes_ = nullptr;
    std::size_t size_ = 0;
    std::FILE* stream_;
};

} // namespace limner
