#include "core/style/extraction/area_means.h"

#include <algorithm>
#include <cmath>

namespace limner {
namespace {

/// Of a pixel: none is added for a rounding error.
constexpr double kRounding = 1e-6;
/// What is opaque stays so, however its shares were rounded.
constexpr float kOpaque = 1 - 4e-6F;

} // namespace

Reduction reductionOf(glm::ivec2 corner, glm::ivec2 size, int longest) {
    Reduction r;
    r.origin = glm::dvec2(corner);
    r.scale = std::max(1.0, std::max(size.x, size.y) / static_cast<double>(std::max(1, longest)));
    const auto count = [&](int length) {
        return std::max(1, static_cast<int>(std::ceil(length / r.scale - kRounding)));
    };
    r.width = count(size.x);
    r.height = count(size.y);
    r.left = corner.x;
    r.right = corner.x + size.x;
    r.top = corner.y;
    r.bottom = corner.y + size.y;
    return r;
}

AreaMeans::AreaMeans(const Reduction& reduction, int firstRow, int endRow, ArtPicture& copy)
    : r_(reduction), copy_(copy), current_(firstRow), end_(endRow), weights_(static_cast<std::size_t>(r_.width)),
      across_(weights_.size()) {
    const auto rowAt = [&](double row) { return r_.origin.y + row * r_.scale; };
    top_ = std::max(r_.top, static_cast<int>(std::floor(rowAt(firstRow) + kRounding)));
    bottom_ = std::min(r_.bottom, static_cast<int>(std::ceil(rowAt(endRow) - kRounding)));
    shares_.reserve(static_cast<std::size_t>(r_.right - r_.left));
    for (int x = r_.left; x < r_.right; ++x) {
        const double from = (x - r_.origin.x) / r_.scale;
        const auto first = std::clamp(static_cast<int>(std::floor(from + kRounding)), 0, r_.width - 1);
        // Of the pixel's length, what lies on that one and on the next.
        const double to = from + 1 / r_.scale;
        const double here = std::min(to, first + 1.0) - std::max<double>(from, first);
        const double next = first + 1 < r_.width ? to - (first + 1) : 0;
        const auto part = [&](double length) {
            return static_cast<float>(length > kRounding ? std::min(1.0, length * r_.scale) : 0);
        };
        const Share share{static_cast<std::size_t>(first), part(here), part(next)};
        weights_[share.first] += share.here;
        if (share.next > 0) {
            weights_[share.first + 1] += share.next;
        }
        shares_.push_back(share);
    }
    sums_.assign(shares_.size(), Rgba{0, 0, 0, 0});
}

void AreaMeans::addRow(int y, std::span<const Rgba> row) {
    const double from = (y - r_.origin.y) / r_.scale;
    const double to = (y + 1 - r_.origin.y) / r_.scale;
    const double edge = current_ + 1;
    if (to < edge - kRounding) {
        add(row, static_cast<float>(std::min(1.0, (to - current_) * r_.scale)));
        return;
    }
    add(row, static_cast<float>(std::clamp((edge - from) * r_.scale, 0.0, 1.0)));
    store();
    if (current_ < end_ && to > edge + kRounding) {
        add(row, static_cast<float>((to - edge) * r_.scale));
    }
}

void AreaMeans::finish() {
    if (current_ < end_ && weight_ > 0) {
        store();
    }
}

void AreaMeans::add(std::span<const Rgba> row, float share) {
    const Rgba* in = row.data();
    Rgba* sum = sums_.data();
    const std::size_t count = std::min(row.size(), sums_.size());
    for (std::size_t i = 0; i < count; ++i) {
        const float opaque = share * in[i].a;
        sum[i].r += opaque * in[i].r;
        sum[i].g += opaque * in[i].g;
        sum[i].b += opaque * in[i].b;
        sum[i].a += opaque;
    }
    weight_ += share;
}

void AreaMeans::store() {
    std::fill(across_.begin(), across_.end(), Rgba{0, 0, 0, 0});
    const auto gather = [](Rgba& into, const Rgba& sum, float share) {
        into.r += share * sum.r;
        into.g += share * sum.g;
        into.b += share * sum.b;
        into.a += share * sum.a;
    };
    for (std::size_t i = 0; i < shares_.size(); ++i) {
        gather(across_[shares_[i].first], sums_[i], shares_[i].here);
        if (shares_[i].next > 0) {
            gather(across_[shares_[i].first + 1], sums_[i], shares_[i].next);
        }
    }
    Rgba* out = copy_.pixels.data() + copy_.offset(0, current_);
    for (std::size_t i = 0; i < across_.size(); ++i) {
        const Rgba& sum = across_[i];
        const float scale = sum.a > 0 ? 1 / sum.a : 0;
        const auto unit = [](float value) { return std::min(value, 1.0F); };
        const float alpha = sum.a / (weights_[i] * weight_);
        out[i] = {unit(sum.r * scale), unit(sum.g * scale), unit(sum.b * scale), alpha > kOpaque ? 1 : alpha};
    }
    std::fill(sums_.begin(), sums_.end(), Rgba{0, 0, 0, 0});
    weight_ = 0;
    ++current_;
}

} // namespace limner
