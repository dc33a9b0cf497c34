/// What one thread of a hearing knows of triangles that came near some pixel. What it hands out stays where
/// it is until it forgets.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "compare/search/by_triangle.h"
#include "compare/search/triangle_filter.h"
#include "compare/truth/neighbourhood.h"

namespace zproof {

/// A triangle as every renderer of a view has it.
struct KnownTriangle {
    KnownTriangle(const TriangleFilters& filters, const CornersWorld& p_world)
        : seen(filters.viewed(p_world)), filter(filters.of(seen)) {}

    ViewedTriangle seen;
    TriangleFilter filter;
};

/// A triangle as one renderer's bounds see it.
struct BoundedTriangle {
    /// `triangle` must outlive it.
    BoundedTriangle(const ViewBounds& bounds, const Camera& camera, const ViewedTriangle& triangle);
    BoundedTriangle(const ViewBounds& bounds, const Camera& camera, ViewedTriangle&& triangle) = delete;

    /// Does it keep between near and far, each moved inwards by its slack, all over the box, certainly?
    bool is_clear_of_planes(const TriangleFilter& filter, const Around& box) const;
    /// Does neither plane cut it within the box (AdmissibleSet::is_clipped), certainly?
    bool is_uncut(const TriangleFilter& filter, const Around& box) const {
        return is_never_cut || is_clear_of_planes(filter, box);
    }
    /// At least its eps anywhere in the box.
    double most_eps_px(const TriangleFilter& filter, const Around& box) const;

    TriangleOfView of_view;
    bool is_never_cut;           ///< no corner reaches a plane
    bool is_always_clear;        ///< nor comes within the slack of one
    double most_near, most_far;  ///< the nearness of the near and far plane, moved inwards by their slack
};

/// Asks memory for the corners of triangles that will be asked about: they lie anywhere in the scene.
void expect_corners(const Scene& scene, std::span<const std::uint32_t> triangles);

class Acquaintance {
  public:
    /// much: triangles, of which one thread knows that many before it forgets; of a tile it may be more. Some
    /// 1.4 KiB each, with the bounds of two renderers: half a mebibyte stays in a core's own cache.
    Acquaintance(const Scene& scene, const View& view, std::size_t much = 384)
        : scene_(scene), view_(view), much_(much), filters_(view) {}

    const KnownTriangle& of(std::uint32_t triangle) {
        return known_(triangle, [&] { return KnownTriangle(filters_, corners_of(scene_, triangle)); });
    }
    const BoundedTriangle& of(std::uint32_t triangle, const ViewBounds& bounds) {
        return bounded_by(bounds)(triangle,
                                  [&] { return BoundedTriangle(bounds, view_.camera, of(triangle).seen); });
    }

    /// expect_corners().
    void expect(std::span<const std::uint32_t> triangles) const { expect_corners(scene_, triangles); }

    /// Triangles that it knows.
    std::size_t count() const { return known_.count(); }
    /// Forgets all, where that has become so much that memory counts for more than asking again.
    void forget_if_much() {
        if (known_.count() <= much_) return;
        known_.forget();
        for (auto& [whose, triangles] : bounded_) triangles.forget();
    }

  private:
    using Bounded = ByTriangle<BoundedTriangle>;
    Bounded& bounded_by(const ViewBounds& bounds) {
        for (auto& [whose, triangles] : bounded_)
            if (whose == &bounds) return triangles;
        return bounded_.emplace_back(&bounds, Bounded()).second;
    }

    const Scene& scene_;
    const View& view_;
    std::size_t much_;
    TriangleFilters filters_;
    ByTriangle<KnownTriangle> known_;
    std::vector<std::pair<const ViewBounds*, Bounded>> bounded_;  ///< a few renderers
};

}  // namespace zproof
