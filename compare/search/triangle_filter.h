/// A triangle's half-planes and nearness over the whole image in double, with the most that rounding may put
/// their values off: what can be said for certain without exact arithmetic (docs/truth.md, "How it is
/// decided").
#pragma once

#include <array>
#include <cmath>

#include "compare/bounds/sight.h"
#include "compare/search/corner_hull.h"
#include "compare/search/filter_terms.h"
#include "compare/truth/neighbourhood.h"
#include "math/affine.h"

namespace zproof {

/// How far an affine function's values in a box may be from that in its middle.
inline double reach(const Affine<double>& f, const Around& box) {
    return box.half_x * std::abs(f.a) + box.half_y * std::abs(f.b);
}

struct TriangleFilter {
    enum class Place {
        misses,   ///< no point of the box is on the closed triangle, certainly
        covers,   ///< every point is inside, certainly
        unknown,  ///< an edge may pass
    };

    std::array<Affine<double>, 3> edge{};  ///< > 0 inside; of pixel indices
    std::array<double, 3> edge_error{};    ///< anywhere in the image: this value's and image_of's together
    Affine<double> nearness{};             ///< of pixel indices
    double nearness_error = unlimited;     ///< anywhere in the image
    bool is_trusted = false;               ///< or may it be edge-on? Then only `box` and `hull` hold
    Box box{};                             ///< around its image in front of half the near depth
    std::optional<CornerHull> hull;        ///< around all of it, where all corners lie in front of that

    Place place_of(const Around& at) const {
        if (!is_trusted) return may_meet(raster_box(at)) ? Place::unknown : Place::misses;
        bool covers = true;
        for (std::size_t k = 0; k < edge.size(); ++k) {
            const Affine<double>& e = edge[k];
            const double middle = e.at(at.x, at.y);
            const double reach = at.half_x * std::abs(e.a) + at.half_y * std::abs(e.b) + edge_error[k];
            if (middle + reach < 0) return Place::misses;
            covers &= middle - reach > 0;
        }
        return covers ? Place::covers : Place::unknown;
    }
    /// Bit k: the box is not inside edge k for certain. For filters that are trusted.
    std::uint32_t edges_within(const Around& at) const {
        std::uint32_t edges = 0;
        for (std::size_t k = 0; k < edge.size(); ++k) {
            const double reach =
                at.half_x * std::abs(edge[k].a) + at.half_y * std::abs(edge[k].b) + edge_error[k];
            edges |= std::uint32_t(!(edge[k].at(at.x, at.y) - reach > 0)) << k;
        }
        return edges;
    }
    bool misses(const Around& at) const { return place_of(at) == Place::misses; }
    /// May it come within reach_px of the pixel's centre, in x and in y?
    bool is_near(int x, int y, double reach_px) const {
        return box.meets(square_around(x, y, reach_px)) &&
               !(is_trusted && misses({double(x), double(y), reach_px, reach_px}));
    }

  private:
    bool may_meet(const Box& asked) const { return box.meets(asked) && !(hull && hull->is_beside(asked)); }
};

/// Is `front` nearer than `back` at every point of the box, certainly: +1; farther at every point: -1; or
/// neither: 0. Both must be trusted.
inline int order_in(const Around& box, const TriangleFilter& front, const TriangleFilter& back) {
    const Affine<double> ahead = front.nearness - back.nearness;
    const double middle = ahead.at(box.x, box.y);
    const double unsure = box.half_x * std::abs(ahead.a) + box.half_y * std::abs(ahead.b) +
                          front.nearness_error + back.nearness_error;
    return middle > unsure ? 1 : middle < -unsure ? -1 : 0;
}

/// Makes the filters of one view.
class TriangleFilters {
  public:
    explicit TriangleFilters(const View& view);

    /// The triangle itself, for any renderer of the view.
    ViewedTriangle viewed(const CornersWorld& p_world) const {
        return {lens_.sight, p_world, any_bounds_.extent_of(p_world)};
    }
    /// Of a triangle that viewed() gave.
    TriangleFilter of(const ViewedTriangle& triangle) const;
    TriangleFilter of(const CornersWorld& p_world) const { return of(viewed(p_world)); }

  private:
    TriangleFilter by_functionals(const ViewedTriangle& triangle) const;

    BoxProjection boxes_;
    ViewBounds any_bounds_;
    FilterLens<double> lens_;
};

FilterLens<double> filter_lens_of(const View& view);

}  // namespace zproof
