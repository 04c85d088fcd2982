#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace limner {

/// SHA-256 of bytes that come in pieces. Throws std::bad_alloc, nothing else.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::span<const std::byte> bytes);
    void add(const std::string& text) { add(std::as_bytes(std::span(text))); }
    /// Of all that was added, as 64 lower-case digits; the sum is over with it.
    [[nodiscard]] std::string hex();

  private:
    struct Free {
        void operator()(void* context) const;
    };
    std::unique_ptr<void, Free> context_;
};

} // namespace limner
