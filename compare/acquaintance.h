/// What one thread of a hearing knows of triangles that came near some pixel. Never forgets, so that what it
/// hands out stays where it is.
#pragma once

#include <span>
#include <unordered_map>

#include "compare/neighbourhood.h"
#include "compare/triangle_filter.h"

namespace zproof {

/// A triangle as every renderer of a view has it.
struct KnownTriangle {
    CornersWorld p_world;
    TriangleExtent extent;
    TriangleFilter filter;
};

/// A triangle as one renderer's bounds see it.
struct BoundedTriangle {
    BoundedTriangle(const ViewBounds& bounds, const Sight<double>& any, const Camera& camera,
                    const KnownTriangle& triangle);

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

class Acquaintance {
  public:
    Acquaintance(const Scene& scene, const View& view)
        : scene_(scene), view_(view), filters_(view), any_(view, 0, 0) {}

    const KnownTriangle& of(std::uint32_t triangle) {
        const auto [place, is_new] = known_.try_emplace(triangle);
        if (is_new) {
            KnownTriangle& known = place->second;
            known.p_world = corners_of(scene_, triangle);
            known.extent = filters_.extent_of(known.p_world);
            known.filter = filters_.of(known.p_world, known.extent);
        }
        return place->second;
    }
    const BoundedTriangle& of(std::uint32_t triangle, const ViewBounds& bounds) {
        auto& bounded = bounded_[&bounds];
        const auto found = bounded.find(triangle);
        if (found != bounded.end()) return found->second;
        return bounded.try_emplace(triangle, bounds, any_, view_.camera, of(triangle))
            .first->second;
    }

  private:
    const Scene& scene_;
    const View& view_;
    TriangleFilters filters_;
    Sight<double> any_;
    std::unordered_map<std::uint32_t, KnownTriangle> known_;
    std::unordered_map<const ViewBounds*, std::unordered_map<std::uint32_t, BoundedTriangle>> bounded_;
};

}  // namespace zproof
