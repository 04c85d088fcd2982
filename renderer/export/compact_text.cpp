#include "renderer/export/compact_text.h"

#include <cmath>

namespace limner {

std::int64_t micrometres(double mm) { return std::llround(mm * 1000); }

CompactText& CompactText::fixed(std::int64_t value, int decimals) {
    if (value < 0) {
        buffer_ += '-';
        value = -value;
    }
    std::int64_t unit = 1;
    for (int i = 0; i < decimals; ++i)
        unit *= 10;
    const std::int64_t whole = value / unit;
    std::int64_t rest = value % unit;
    if (whole > 0 || rest == 0)
        buffer_ += std::to_string(whole);
    if (rest > 0) {
        buffer_ += '.';
        for (unit /= 10; rest > 0; unit /= 10) {
            buffer_ += static_cast<char>('0' + rest / unit);
            rest %= unit;
        }
    }
    return full();
}

CompactText& CompactText::number(double value, int decimals) {
    return fixed(std::llround(value * std::pow(10.0, decimals)), decimals);
}

void CompactText::flush() {
    if (!buffer_.empty())
        take_(buffer_);
    buffer_.clear();
}

} // namespace limner
