/// The triangles that come near one pixel, each with its derived bounds there: all evidence that the
/// admissible set is decided from. Plain numbers; the judge takes them as exact.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "compare/bounds/bounds.h"
#include "compare/bounds/pixel_coord.h"
#include "compare/bounds/triangle_image.h"
#include "frame/frame.h"

namespace zproof {

/// A pixel to be looked into, with every triangle whose image may come within reach_px of its centre.
struct SearchPixel {
    int x = 0, y = 0;
    double reach_px = 0;
    std::vector<std::uint32_t> triangles;  ///< ascending
};

struct Neighbour : TriangleLimits {
    std::uint32_t triangle = 0;
    CornersWorld p_world;
    LocalBounds bounds;
    double gradient = 0;          ///< |d/dx| + |d/dy| of inverse depth, per px; 0 for an edge-on triangle
    bool is_plane_known = false;  ///< or does double precision not tell it from edge-on?
    bool is_trusted = false;      ///< the same, and is the sign of its image's edges certain?
    /// The image of p_world: whoever changes one changes both. In double; nothing for an edge-on triangle. It
    /// is off by at most `edge_error` and `plane_error` (of inverse depth) anywhere within a pixel of the
    /// centre.
    std::optional<TriangleImage<double>> image;
    std::array<Affine<double>, 3> edges{};  ///< the image's; without an image, of no orientation
    double edge_error = 0, plane_error = 0;
    /// What a faultless renderer may hold for its inverse depth at the pixel, all bounds included.
    double least_inverse_depth = 0, greatest_inverse_depth = 0;
};

struct Neighbourhood {
    View view;
    int x = 0, y = 0;
    double eps_px =
        0;  ///< half-side of the square: the largest eps of the answer and the triangles around it
    bool is_watertight = true;           ///< does the renderer move triangles that share an edge alike?
    std::vector<Window> clip_windows{};  ///< of ViewBounds
    std::vector<Neighbour> neighbours;   ///< in triangle order
    std::size_t most_work = 500'000;     ///< a decision that would take more is left open (TooMuchWork)

    /// The triangle's place among the neighbours, if it is there.
    std::optional<std::size_t> index_of(PrimitiveId triangle) const;
};

/// What one triangle brings to every pixel of a view by one renderer's bounds.
struct BoundedTriangle {
    BoundedTriangle(const ViewBounds& of_view, const CornersWorld& p)
        : BoundedTriangle(of_view, p, of_view.extent_of(p)) {}
    /// `extent` is the triangle's, by the bounds of any renderer of the view.
    BoundedTriangle(const ViewBounds& of_view, const CornersWorld& p, const TriangleExtent& extent)
        : p_world(p),
          plane_error(extent.size.plane),
          ray_size(of_view.ray_size()),
          bounds(of_view.of(extent)),
          keeps_to_corners(of_view.keeps_to_corners()) {}

    CornersWorld p_world;
    PlaneError plane_error;
    ViewBounds::RaySize ray_size;
    TriangleBounds bounds;
    bool keeps_to_corners;
};

/// Does the image come within eps of the centre? An estimate in double: it only decides whose eps counts.
bool comes_within(const TriangleImage<double>& image, double eps_px);

/// What one triangle is at a pixel, whoever draws it: its image, with its errors. `triangle` is left 0.
Neighbour seen_at(const ViewRay<double>& ray, const BoundedTriangle& triangle);
/// Sets what depends on the renderer.
void set_bounds(Neighbour& seen, const BoundedTriangle& triangle, Projection projection);
/// Both steps in one: seen_at() and set_bounds().
Neighbour neighbour_of(const ViewRay<double>& ray, const BoundedTriangle& triangle);
inline Neighbour neighbour_of(const ViewRay<double>& ray, const ViewBounds& bounds,
                              const CornersWorld& p_world) {
    return neighbour_of(ray, BoundedTriangle(bounds, p_world));
}

/// eps of an answer by itself, before its surroundings are looked at.
double own_eps_px(const Scene& scene, const View& view, const ViewBounds& bounds, const PixelCoord& place,
                  PrimitiveId answer);

/// Gathers the evidence for an answer whose own eps is own_eps_px <= site.reach_px. Where the result's eps_px
/// exceeds site.reach_px, triangles may be missing: look again with that reach; the result's eps_px will be
/// the same.
Neighbourhood neighbourhood_of(const Scene& scene, const View& view, const ViewBounds& bounds,
                               const SearchPixel& search_pixel, double own_eps_px);

}  // namespace zproof
