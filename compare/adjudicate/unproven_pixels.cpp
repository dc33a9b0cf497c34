#include "compare/adjudicate/unproven_pixels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

#include "compare/adjudicate/image_box.h"
#include "compare/admissible/neighbourhood.h"
#include "compare/bounds/triangle_depth.h"

namespace zproof {

namespace {

/// Marks the pixels at which a triangle's edges, and its cuts by near and far, pass nearer than the reference
/// may be off, where the candidate may be off by less. Its functionals are those of pixel indices.
class CoarseOutline {
  public:
    /// `box` is around the triangle's image. If no pixel shows it, only those matter that it truly holds.
    CoarseOutline(const FramePair& frames, std::uint32_t triangle, const Box& box, bool is_shown)
        : view_(frames.view),
          p_world_(corners_of(frames.scene, triangle)),
          in_view_(view_, frames.reference.bounds, p_world_),
          reference_(frames.reference.bounds.of(in_view_.extent)),
          candidate_(frames.candidate.bounds.of(in_view_.extent)),
          first_(
              seen_at(ViewRay<double>(view_, 0, 0), {frames.reference.bounds, p_world_, in_view_.extent})) {
        box_ = box;
        if (is_shown) box_.widen(reference_.most_eps_px() + 1);
        box_ = {std::max(box_.left - 0.5, 0.0), std::max(box_.top - 0.5, 0.0),
                std::min(box_.right - 0.5, view_.width - 1.0),
                std::min(box_.bottom - 0.5, view_.height - 1.0)};
    }

    void mark(Plane<std::uint8_t>& pixels) {
        if (box_.is_empty()) return;
        const Span here = inverse_depths();
        const BoundsOnPlane reference(reference_, in_view_.gradient),
            candidate(candidate_, in_view_.gradient);
        const auto is_finer_at = [&](double inverse_depth) {
            return reference.at(inverse_depth).eps_px <= candidate.at(inverse_depth).eps_px;
        };
        const bool is_finer = is_finer_at(here.low) && is_finer_at(here.high);
        eps_px_ = reference.at(here.high).eps_px;
        if (reference_.may_be_missing && !candidate_.may_be_missing) mark_band({0, 0, 0}, 0, pixels);
        for (const Affine<double>& edge : first_.edges)
            if (!is_finer) mark_band(edge, reach_of(edge), pixels);
        const Camera& c = view_.camera;
        if (!is_finer || reference_.near_slack > candidate_.near_slack) mark_cut(c.near_depth, here, pixels);
        if (!is_finer || reference_.far_slack > candidate_.far_slack) mark_cut(c.far_depth, here, pixels);
    }

  private:
    struct Span {
        double low, high;
    };
    /// What an edge may be off by, with our own error anywhere in the image.
    double reach_of(const Affine<double>& edge) const {
        return eps_px_ * (std::abs(edge.a) + std::abs(edge.b)) +
               first_.edge_error * (view_.width + view_.height);
    }

    /// What the triangle may have of a row, its edges moved outwards.
    Span columns(int y) const {
        Span span{box_.left, box_.right};
        if (!first_.is_trusted) return span;
        for (const Affine<double>& edge : first_.edges) {
            const double here = edge.b * y + edge.c + reach_of(edge), at = -here / edge.a;
            if (edge.a == 0 && here < 0) return {0, -1};
            if (edge.a > 0) span.low = std::max(span.low, at);
            if (edge.a < 0) span.high = std::min(span.high, at);
        }
        return span;
    }

    /// What the triangle's plane has in the box.
    Span inverse_depths() const {
        const Affine<double>& f = in_view_.inverse_depth;
        const double middle = f.at((box_.left + box_.right) / 2, (box_.top + box_.bottom) / 2),
                     reach = (std::abs(f.a) * (box_.right - box_.left) +
                              std::abs(f.b) * (box_.bottom - box_.top)) /
                                 2 +
                             in_view_.own_error;
        if (in_view_.is_edge_on || !std::isfinite(reach)) return {-unlimited, unlimited};
        return {middle - reach, middle + reach};
    }

    /// Pixels of the box at which |f| <= margin.
    void mark_band(const Affine<double>& f, double margin, Plane<std::uint8_t>& pixels) const {
        for (int y = int(std::ceil(box_.top)); y <= box_.bottom; ++y) {
            const double here = f.b * y + f.c, middle = -here / f.a, reach = margin / std::abs(f.a);
            if (f.a == 0 && !(std::abs(here) <= margin)) continue;
            const bool is_bounded = std::isfinite(middle) && std::isfinite(reach);
            const Span row = columns(y);
            const double left = is_bounded ? std::max(middle - reach, row.low) : row.low,
                         right = is_bounded ? std::min(middle + reach, row.high) : row.high;
            if (!(left <= right)) continue;
            for (int x = int(std::ceil(left)); x <= right; ++x)
                std::atomic_ref(pixels.at(x, y)).store(1, std::memory_order_relaxed);
        }
    }

    /// Pixels at which the reference may cut it by near or far where it is not cut, or the other way round.
    void mark_cut(double depth, const Span& here, Plane<std::uint8_t>& pixels) const {
        if (!std::isfinite(depth) || in_view_.is_edge_on) return;
        const bool perspective = view_.camera.projection == Projection::perspective;
        const LocalBounds local = BoundsOnPlane(reference_, in_view_.gradient).at(here.high);
        const double largest = std::max(std::abs(here.low), std::abs(here.high));
        const double of_depth =
            perspective ? compounded(local.depth_relative + local.depth_absolute * largest) * largest
                        : local.depth_relative * largest + local.depth_absolute;
        Affine<double> f = in_view_.inverse_depth;
        f.c = f.c - inverse_depth_of(depth, view_.camera.projection);
        mark_band(f, of_depth + local.inverse_depth_error + in_view_.gradient * eps_px_ + in_view_.own_error,
                  pixels);
    }

    const View& view_;
    CornersWorld p_world_;
    TriangleInView in_view_;
    TriangleBounds reference_, candidate_;
    Neighbour first_;    ///< at pixel (0, 0)
    Box box_;            ///< of pixel indices
    double eps_px_ = 0;  ///< the reference's, at its largest in the box
};

/// 1 for each triangle that the frame shows somewhere.
std::vector<std::uint8_t> shown_by(const Frame& frame, std::size_t triangle_count) {
    std::vector<std::uint8_t> is_shown(triangle_count);
    for (const PrimitiveId id : frame.primitive.pixels())
        if (std::size_t(id) < triangle_count) is_shown[std::size_t(id)] = 1;
    return is_shown;
}

/// Does the box of raster space hold a pixel's centre?
bool holds_a_centre(const Box& box) {
    return std::floor(box.right - 0.5) >= box.left - 0.5 && std::floor(box.bottom - 0.5) >= box.top - 0.5;
}

/// Where the reference shows a triangle farther beyond its corners than the candidate displaces it: by
/// rounding, which proves nothing unless the candidate's edges err as much.
class BeyondCorners {
  public:
    BeyondCorners(const FramePair& frames, std::uint32_t triangle)
        : frames_(frames),
          p_world_(corners_of(frames.scene, triangle)),
          image_(BoxProjection(frames.view)(p_world_)) {}

    bool holds(const glm::dvec2& p_raster) const {
        if (image_.holds(p_raster.x, p_raster.y)) return false;
        const auto rounding = [](const TriangleBounds& b) { return std::ranges::max(b.edge_rounding_px); };
        const TriangleBounds candidate = frames_.candidate.bounds.of(p_world_);
        Box displaced = image_;
        displaced.widen(candidate.most_eps_px());
        return !displaced.holds(p_raster.x, p_raster.y) &&
               rounding(candidate) < rounding(frames_.reference.bounds.of(p_world_));
    }

  private:
    const FramePair& frames_;
    CornersWorld p_world_;
    Box image_;
};

/// Marks the pixels at which the reference shows one of these triangles beyond its corners.
void mark_beyond_corners(const FramePair& frames, const std::vector<std::uint8_t>& is_thin,
                         Plane<std::uint8_t>& pixels) {
    if (std::ranges::count(is_thin, 1) == 0) return;
    tbb::parallel_for(0, frames.view.height, [&](int y) {
        std::size_t shown = is_thin.size();
        std::optional<BeyondCorners> beyond;  // of the triangle that is shown, where it is thin
        for (int x = 0; x < frames.view.width; ++x) {
            const auto i = std::size_t(frames.reference.frame.primitive.at(x, y));
            if (i != shown) {
                shown = i;
                beyond.reset();
                if (i < is_thin.size() && is_thin[i]) beyond.emplace(frames, std::uint32_t(i));
            }
            if (beyond && beyond->holds(sampled_at(frames.view, x, y))) pixels.at(x, y) = 1;
        }
    });
}

/// Is it the reference's own renderer that is judged? Then all bits are the same.
bool is_judged_by_itself(const FramePair& frames) {
    const Frame &candidate = frames.candidate.frame, &reference = frames.reference.frame;
    return std::ranges::equal(candidate.primitive.pixels(), reference.primitive.pixels()) &&
           std::ranges::equal(candidate.camera_depth.pixels(), reference.camera_depth.pixels());
}

}  // namespace

double beyond_corners_px(const std::array<Affine<double>, 3>& edges, double moved_px) {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Affine<double>&e = edges[i], &f = edges[(i + 1) % 3];
        const double slopes = std::sqrt((e.a * e.a + e.b * e.b) * (f.a * f.a + f.b * f.b)),
                     sine = std::abs(e.a * f.b - f.a * e.b) / slopes;
        most = std::max(most, sine > 0 ? 2 * moved_px / sine : unlimited);
    }
    return most;
}

Plane<std::uint8_t> find_unproven_pixels(const FramePair& frames) {
    if (is_judged_by_itself(frames)) return Plane<std::uint8_t>(frames.candidate.frame.size(), 1);
    const BoxProjection project(frames.view);
    const double fine_px = frames.candidate.bounds.least_eps_px();
    const bool may_have_gaps =
        frames.candidate.bounds.is_watertight() && !frames.reference.bounds.is_watertight();
    Plane<std::uint8_t> is_unproven(Resolution{frames.view.width, frames.view.height}, may_have_gaps);
    const std::size_t count = frames.scene.triangles.size();
    const std::vector<std::uint8_t> is_shown = shown_by(frames.reference.frame, count);
    std::vector<std::uint8_t> is_thin(count);
    const ViewRay<double> first_pixel(frames.view, 0, 0);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) {
        const CornersWorld p_world = corners_of(frames.scene, std::uint32_t(i));
        const Box box = project(p_world);
        if (box.is_empty() || !(is_shown[i] || holds_a_centre(box))) return;
        const TriangleBounds bounds = frames.reference.bounds.of(p_world);
        is_thin[i] = is_shown[i] && bounds.may_be_shown_by_rounding() &&
                     beyond_corners_px(edges_of(first_pixel, corners<double>(p_world)),
                                       bounds.most_eps_px()) > fine_px;
        if (!(bounds.most_eps_px() <= fine_px) || bounds.may_be_missing ||
            bounds.may_be_clipped(frames.view.camera))
            CoarseOutline(frames, std::uint32_t(i), box, is_shown[i] != 0).mark(is_unproven);
    });
    mark_beyond_corners(frames, is_thin, is_unproven);
    return is_unproven;
}

}  // namespace zproof
