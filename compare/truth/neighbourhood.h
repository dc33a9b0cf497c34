/// The triangles that come near one pixel, each with its derived bounds there: all evidence that the
/// admissible set is decided from. Plain numbers; the judge takes them as exact.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "compare/bounds/bounds.h"
#include "compare/bounds/nearness_range.h"
#include "compare/pixel_place.h"
#include "compare/truth/coplanar.h"
#include "compare/truth/image_of_view.h"
#include "frame/frame.h"

namespace zproof {

/// A pixel to be looked into, with every triangle whose image may come within reach_px of its centre.
struct Site {
    int x = 0, y = 0;
    double reach_px = 0;
    std::vector<std::uint32_t> triangles;  ///< ascending
};

struct Neighbour {
    std::uint32_t triangle = 0;
    CornersWorld p_world;
    LocalBounds bounds;
    double near_slack = 0, far_slack = 0;  ///< see TriangleBounds
    double nearest = 0, farthest = 0;      ///< see TriangleBounds
    double gradient = 0;                   ///< |d/dx| + |d/dy| of nearness, per px; 0 for an edge-on triangle
    bool is_plane_known = false;           ///< or does double precision not tell it from edge-on?
    /// Of p_world: whoever changes one changes both. In double; nothing for an edge-on triangle. Off by at
    /// most `edge_error` and `plane_error` (of nearness) anywhere within a pixel of the centre.
    std::optional<TriangleImage<double>> image;
    double edge_error = 0, plane_error = 0;
    /// What a faultless renderer may hold for its nearness at the pixel, all bounds included.
    double least_nearness = 0, greatest_nearness = 0;

    CoplanarMemory::Triangle of_scene() const { return {triangle, p_world}; }
};

struct Neighbourhood {
    View view;
    int x = 0, y = 0;
    double eps_px =
        0;  ///< half-side of the square: the largest eps of the answer and the triangles around it
    std::vector<Neighbour> neighbours;  ///< in triangle order

    /// Of a triangle among the neighbours.
    std::optional<std::size_t> index_of(PrimitiveId triangle) const;
};

CornersWorld corners_of(const Scene& scene, std::uint32_t triangle);

/// What one triangle is at every pixel of a view, whoever draws it.
struct ViewedTriangle {
    /// `any` is the sight of any pixel of the view.
    ViewedTriangle(const ViewBounds& of_view, const Sight<double>& any, const CornersWorld& p)
        : ViewedTriangle(any, p, of_view.extent_of(p)) {}
    ViewedTriangle(const Sight<double>& any, const CornersWorld& p, const TriangleExtent& e)
        : p_world(p), extent(e), image(any, p), plane_error(e.size.plane) {}

    CornersWorld p_world;
    TriangleExtent extent;
    ImageOfView image;
    PlaneError plane_error;
};

/// What it brings there by one renderer's bounds.
struct TriangleOfView {
    /// `triangle` must outlive it.
    TriangleOfView(const ViewBounds& of_view, const ViewedTriangle& triangle);
    TriangleOfView(const ViewBounds& of_view, ViewedTriangle&& triangle) = delete;

    /// The renderer's bounds at a place of the triangle's plane; `gradient` as TriangleBounds::at has it.
    LocalBounds bounds_at(double nearness, double gradient) const {
        return on_plane ? on_plane->at(nearness) : bounds.at(nearness, gradient);
    }
    /// eps at a pixel, the very bits of neighbour_of(...).bounds.eps_px.
    double eps_px(const Sight<double>& sight) const;

    const ViewedTriangle* seen;
    TriangleBounds bounds;
    std::optional<BoundsOnPlane> on_plane;  ///< where its gradient is the same at every pixel
    bool keeps_to_corners;
};

/// Where what a triangle brings is kept.
using TriangleLookUp = std::function<const TriangleOfView&(std::uint32_t)>;

/// Does the image come within eps of the centre? An estimate in double: it only decides whose eps counts.
bool comes_within(const TriangleImage<double>& image, double eps_px);

/// One triangle's bounds at a pixel (`triangle` is left 0).
Neighbour neighbour_of(const Sight<double>& sight, const TriangleOfView& triangle);
/// What it says of nearness, in the same bits.
NearnessRange nearness_range_of(const Sight<double>& sight, const TriangleOfView& triangle);
Neighbour neighbour_of(const Sight<double>& sight, const ViewBounds& bounds, const CornersWorld& p_world);

/// eps of an answer by itself, before its surroundings are looked at.
double own_eps_px(const Scene& scene, const View& view, const ViewBounds& bounds, const PixelPlace& place,
                  PrimitiveId answer);

/// Gathers the evidence for an answer whose own eps is
/// own_eps_px <= site.reach_px. Where the result's eps_px exceeds site.reach_px, triangles may be missing:
/// look again with that reach; the result's eps_px will be the same.
Neighbourhood neighbourhood_of(const Scene& scene, const View& view, const ViewBounds& bounds,
                               const Site& site, double own_eps_px);
/// The same.
Neighbourhood neighbourhood_of(const View& view, const Site& site, double own_eps_px,
                               const TriangleLookUp& triangle_of_view);

}  // namespace zproof
