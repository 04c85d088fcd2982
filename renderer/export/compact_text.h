#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace limner {

/// Text that is written as it is made, in pieces. Numbers take no more characters than they need.
class CompactText {
  public:
    using Take = std::function<void(std::string_view)>;
    explicit CompactText(Take take) : take_(std::move(take)) { buffer_.reserve(kPiece + kLongest); }

    CompactText& operator<<(std::string_view text) {
        buffer_ += text;
        return full();
    }
    CompactText& operator<<(const char* text) { return *this << std::string_view(text); }
    CompactText& operator<<(char letter) {
        buffer_ += letter;
        return full();
    }
    /// value / 10^decimals.
    CompactText& fixed(std::int64_t value, int decimals);
    /// Rounded to so many decimals.
    CompactText& number(double value, int decimals);
    /// Hands out what is left.
    void flush();

  private:
    static constexpr std::size_t kPiece = std::size_t{1} << 16;
    static constexpr std::size_t kLongest = 1024;

    CompactText& full() {
        if (buffer_.size() >= kPiece)
            flush();
        return *this;
    }

    Take take_;
    std::string buffer_;
};

/// Places in vector files are whole micrometres.
constexpr int kPlaceDecimals = 3;
std::int64_t micrometres(double mm);

} // namespace limner
