#include "compare/search/triangle_filter.h"

#include <algorithm>

namespace zproof {

namespace {

double size_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

FilterLens<double> filter_lens_of(const View& view) {
    const Camera& c = view.camera;
    const double u = std::max(std::abs(c.window.left), std::abs(c.window.right));
    const double v = std::max(std::abs(c.window.bottom), std::abs(c.window.top));
    const double on_plane = u * size_of(c.right) + v * size_of(c.up);
    const double sheared = std::abs(c.shear.x) * size_of(c.right) + std::abs(c.shear.y) * size_of(c.up);
    const bool is_perspective = c.projection == Projection::perspective;
    return {.sight = Sight<double>(view, 0, 0),
            .width = double(view.width),
            .height = double(view.height),
            .origin_size = size_of(glm::dvec3(c.eye_world)) + on_plane,
            .direction_size = (is_perspective ? on_plane : sheared) + size_of(c.back)};
}

TriangleFilters::TriangleFilters(const View& view)
    : boxes_(view), any_bounds_(view, RasterPrecision{}), lens_(filter_lens_of(view)) {}

TriangleFilter TriangleFilters::of(const ViewedTriangle& triangle) const {
    TriangleFilter filter = by_functionals(triangle);
    const std::optional<CornerBoxes> corners = boxes_.of_corners(triangle.p_world);
    if (corners)
        filter.box = corners->all();
    else if (const auto box = boxes_(triangle.p_world))
        filter.box = *box;
    if (corners && !filter.is_trusted) filter.hull.emplace(*corners);
    return filter;
}

TriangleFilter TriangleFilters::by_functionals(const ViewedTriangle& triangle) const {
    TriangleFilter filter;
    if (!triangle.plane_error.is_known()) return filter;
    FilterLens<double>::Edges edges{};
    if (lens_.is_perspective()) {
        const auto image = triangle.image.at_any();
        if (!image) return filter;
        edges = image->edge;
    }
    const FilterTerms<double> terms =
        lens_.terms_of(corners<double>(triangle.p_world), triangle.plane_error, edges);
    filter.edge = terms.edge;
    filter.edge_error = terms.edge_error;
    filter.nearness = terms.nearness;
    filter.nearness_error = terms.nearness_error;
    filter.is_trusted = terms.is_trusted;
    return filter;
}

}  // namespace zproof
