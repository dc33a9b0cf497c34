/// Boxes of raster space in single precision: quick to join and to compare.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "compare/search/image_box.h"

namespace zproof {

/// A closed box, pixels; empty at first.
class FloatBox {
  public:
    FloatBox() = default;
    FloatBox(float left, float top, float right, float bottom) : least_{left, top, -right, -bottom} {}

    /// Rounded outwards: by more than a float is off. What begins beyond all floats begins at the last.
    static FloatBox holding(const Box& box) {
        constexpr double last = std::numeric_limits<float>::max();
        const auto more = [](double a) { return std::abs(a) * 0x1p-23 + 0x1p-126; };
        const auto below = [&](double a) { return float(std::min(a - more(a), last)); };
        const auto above = [&](double a) { return float(std::max(a + more(a), -last)); };
        return {below(box.left), below(box.top), above(box.right), above(box.bottom)};
    }
    static FloatBox everywhere() { return {-unlimited_px, -unlimited_px, unlimited_px, unlimited_px}; }

    float left() const { return least_[0]; }
    float top() const { return least_[1]; }
    float right() const { return -least_[2]; }
    float bottom() const { return -least_[3]; }
    Box in_double() const { return {left(), top(), right(), bottom()}; }

    void add(const FloatBox& o) { least_ = least_ < o.least_ ? least_ : o.least_; }
    bool fits(float side_px) const { return right() - left() <= side_px && bottom() - top() <= side_px; }
    bool is_everywhere() const {
        return right() - left() == unlimited_px && bottom() - top() == unlimited_px;
    }
    bool meets(const FloatBox& o) const {
        const Sides across = least_ + __builtin_shufflevector(o.least_, o.least_, 2, 3, 0, 1);
        const auto is_met = Halves(across <= 0.0F);
        return (is_met[0] & is_met[1]) == ~std::uint64_t{0};
    }

    /// left, top, right and bottom.
    using Places [[gnu::vector_size(16)]] = std::int32_t;
    /// The sides over a cell's, each whole, and held between 0 and the last cells.
    Places cells(float side_px, const Places& last) const {
        const float per_px = 1 / side_px;
        const Sides most = __builtin_convertvector(last, Sides), none{};
        const Sides raised = least_ * Sides{per_px, per_px, -per_px, -per_px};
        const Sides from_none = raised > none ? raised : none;
        return __builtin_convertvector(from_none < most ? from_none : most, Places);
    }

  private:
    static constexpr float unlimited_px = std::numeric_limits<float>::infinity();

    using Sides [[gnu::vector_size(16)]] = float;
    using Halves [[gnu::vector_size(16)]] = std::uint64_t;
    /// Left and top, and right and bottom with another sign: of several boxes' the minimum holds them all.
    Sides least_{unlimited_px, unlimited_px, unlimited_px, unlimited_px};
};

}  // namespace zproof
