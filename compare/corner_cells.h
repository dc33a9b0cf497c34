/// Which tiles of the image a triangle's corners may reach: a few bytes for each corner, so that most
/// triangles are known to be far from all that is asked about before any box is made.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "compare/image_box.h"

namespace zproof {

/// The image cut into cells; what lies beyond it counts to the cells at its border.
struct Cells {
    static constexpr int side_px = 4;

    int columns = 0, rows = 0;

    explicit Cells(const View& view)
        : columns((view.width + side_px - 1) / side_px), rows((view.height + side_px - 1) / side_px) {}
    int column_of(double x_px) const { return clamped(x_px, columns); }
    int row_of(double y_px) const { return clamped(y_px, rows); }

  private:
    static int clamped(double px, int count) { return int(std::clamp(px / side_px, 0.0, count - 1.0)); }
};

/// The cells that a corner may lie in; of several corners, those between them. Four numbers, left, top, right
/// and bottom; the latter two are negated, so that the reach of several is their minimum.
class CellReach {
  public:
    CellReach() = default;
    CellReach(int left, int top, int right, int bottom)
        : least_{std::int16_t(left), std::int16_t(top), std::int16_t(-right), std::int16_t(-bottom)} {}

    static CellReach of(const CellReach& a, const CellReach& b, const CellReach& c) {
        CellReach all;
        const Four ab = a.least_ < b.least_ ? a.least_ : b.least_;
        all.least_ = ab < c.least_ ? ab : c.least_;
        return all;
    }
    void add(const CellReach& other) { least_ = least_ < other.least_ ? least_ : other.least_; }
    int left() const { return least_[0]; }
    int top() const { return least_[1]; }
    int right() const { return -least_[2]; }
    int bottom() const { return -least_[3]; }

  private:
    using Four [[gnu::vector_size(8)]] = std::int16_t;
    Four least_;
};

/// Finds them for many corners.
class CornerCells {
  public:
    CornerCells(const BoxProjection& projection, const Cells& cells)
        : terms_(projection.terms()), cells_(cells) {}

    /// `reach` has as many places as there are corners. A corner of which no place in the image can be told
    /// reaches everywhere.
    void find(std::span<const glm::vec3> p_world, std::span<CellReach> reach) const;

  private:
    BoxProjection::Terms terms_;
    Cells cells_;
};

}  // namespace zproof
