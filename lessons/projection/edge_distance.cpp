#include "lessons/projection/edge_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "compare/bounds/bounds.h"

namespace zproof::study::projection {

namespace {

/// Sides of all triangles that may pass near a place, found by squares of the picture.
class SideIndex {
  public:
    SideIndex(const Scene& scene, const Outliner& outliner, Resolution size)
        : columns_(size.width / side_px + 1),
          squares_(std::size_t(columns_) * std::size_t(size.height / side_px + 1)) {
        const glm::dvec2 low{-1, -1}, high{size.width + 1, size.height + 1};
        for (std::size_t t = 0; t < scene.triangles.size(); ++t)
            for (const RasterSegment& side : outliner.sides(PrimitiveId(t)))
                if (const auto shown = within(side, low, high)) add(*shown, size);
    }

    double nearest(const RasterSegment& line) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (const RasterSegment& side : squares_[square(int(line.a.x), int(line.a.y))])
            nearest = std::min(nearest, distance_between(line, side));
        return nearest;
    }

  private:
    static constexpr int side_px = 16;
    std::size_t square_at(int column, int row) const {
        return std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    }
    std::size_t square(int x, int y) const { return square_at(x / side_px, y / side_px); }

    /// Adds the side to every square that it comes within 2 px of.
    void add(const RasterSegment& side, Resolution size) {
        const auto cell = [](double at, int count) {
            return int(std::clamp(at, 0.0, count - 1.0)) / side_px;
        };
        const int left = cell(std::min(side.a.x, side.b.x) - 2, size.width),
                  right = cell(std::max(side.a.x, side.b.x) + 2, size.width),
                  top = cell(std::min(side.a.y, side.b.y) - 2, size.height),
                  bottom = cell(std::max(side.a.y, side.b.y) + 2, size.height);
        for (int j = top; j <= bottom; ++j)
            for (int i = left; i <= right; ++i)
                if (within(side, {i * side_px - 2, j * side_px - 2},
                           {(i + 1) * side_px + 2, (j + 1) * side_px + 2}))
                    squares_[square_at(i, j)].push_back(side);
    }

    int columns_;
    std::vector<std::vector<RasterSegment>> squares_;
};

class Surveyor {
  public:
    Surveyor(const Scene& scene, const View& view, const Precision& precision)
        : scene_(scene), outliner_(scene, view), bounds_(view, precision), size_{view.width, view.height} {}

    EdgeAgreement survey(const Plane<PrimitiveId>& ids) {
        for (int y = 0; y < size_.height; ++y)
            for (int x = 0; x < size_.width; ++x) {
                if (x + 1 < size_.width) look(ids, {x, y, x + 1, y, 0, 0});
                if (y + 1 < size_.height) look(ids, {x, y, x, y + 1, 0, 0});
            }
        for (const Boundary& boundary : unexplained_) look_farther(boundary);
        std::ranges::sort(found_.displaced_px);
        return std::move(found_);
    }

  private:
    static RasterSegment centres(const Boundary& b) {
        return {{b.x + 0.5, b.y + 0.5}, {b.to_x + 0.5, b.to_y + 0.5}};
    }

    void look(const Plane<PrimitiveId>& ids, Boundary boundary) {
        const std::array both{ids.at(boundary.x, boundary.y), ids.at(boundary.to_x, boundary.to_y)};
        if (both[0] == both[1]) return;
        ++found_.boundaries;
        const RasterSegment line = centres(boundary);
        double eps = bounds_.background_eps_px();
        boundary.distance_px = std::numeric_limits<double>::infinity();
        for (const PrimitiveId id : both) {
            if (id == PrimitiveId::none) continue;
            eps = std::max(eps, largest_eps(id));
            for (const RasterSegment& side : outliner_.sides(id))
                boundary.distance_px = std::min(boundary.distance_px, distance_between(line, side));
        }
        boundary.expected_px = std::numbers::sqrt2 * eps;
        sort_in(boundary, both, line);
    }

    void sort_in(const Boundary& boundary, const std::array<PrimitiveId, 2>& both,
                 const RasterSegment& line) {
        if (boundary.distance_px == 0) {
            ++found_.crossed;
        } else if (boundary.distance_px <= boundary.expected_px) {
            ++found_.displaced;
            note(boundary);
        } else if (hold_both(both, line)) {
            ++found_.by_depth;
        } else {
            unexplained_.push_back(boundary);
        }
    }

    bool hold_both(const std::array<PrimitiveId, 2>& both, const RasterSegment& line) const {
        return std::ranges::all_of(both, [&](PrimitiveId id) {
            return id != PrimitiveId::none && outliner_.holds(id, line.a) && outliner_.holds(id, line.b);
        });
    }

    /// A third triangle's edge may end what is seen of the first.
    void look_farther(const Boundary& boundary) {
        if (index_.empty()) index_.emplace_back(scene_, outliner_, size_);
        if (index_.front().nearest(centres(boundary)) <= boundary.expected_px) {
            ++found_.by_others;
            return;
        }
        ++found_.beyond;
        note(boundary);
    }

    void note(const Boundary& boundary) {
        found_.displaced_px.push_back(boundary.distance_px);
        found_.largest_share = std::max(found_.largest_share, boundary.distance_px / boundary.expected_px);
        if (boundary.distance_px <= found_.largest_px) return;
        found_.largest_px = boundary.distance_px;
        found_.farthest = boundary;
    }

    double largest_eps(PrimitiveId id) const {
        return bounds_.of(corners_of(scene_, std::uint32_t(id))).most_eps_px();
    }

    const Scene& scene_;
    Outliner outliner_;
    ViewBounds bounds_;
    Resolution size_;
    EdgeAgreement found_;
    std::vector<Boundary> unexplained_;
    std::vector<SideIndex> index_;  ///< made when first asked for
};

}  // namespace

EdgeAgreement edge_agreement(const Scene& scene, const View& view, const Plane<PrimitiveId>& ids,
                             const Precision& precision) {
    return Surveyor{scene, view, precision}.survey(ids);
}

}  // namespace zproof::study::projection
