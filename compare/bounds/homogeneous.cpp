#include "compare/bounds/homogeneous.h"

#include <algorithm>
#include <cmath>

#include "compare/bounds/depth_bound.h"
#include "compare/bounds/roundings.h"

namespace zproof {

namespace {

/// Corners before the divide: exactly, and the largest that matrices may make of their coordinates.
struct CornersBeforeDivide {
    std::array<glm::dvec3, 3> exact, largest;

    CornersBeforeDivide(const ViewFacts& facts, const TriangleExtent& extent, const glm::dvec3& moved) {
        const glm::dvec3 shift{moved.x + facts.scale.slant_u * (facts.perspective ? 0 : moved.z),
                               moved.y + facts.scale.slant_v * (facts.perspective ? 0 : moved.z),
                               facts.perspective ? moved.z : 0};
        for (std::size_t i = 0; i < 3; ++i) {
            exact[i] =
                glm::dvec3(facts.before_divide(extent, i), facts.perspective ? extent.size.depth[i] : 1.0);
            largest[i] = glm::abs(exact[i]) + shift;
        }
    }
};

/// One edge function: its terms in absolute value, and how steep it is in the image at least.
struct EdgeSize {
    double terms, least_slope;
};

EdgeSize edge_size(const ViewFacts& facts, const CornersBeforeDivide& corners, std::size_t edge) {
    const std::size_t from = (edge + 1) % 3, to = (edge + 2) % 3;
    const glm::dvec3 normal = glm::abs(glm::cross(corners.exact[from], corners.exact[to]));
    const glm::dvec3 terms = abs_cross(corners.largest[from], corners.largest[to]);
    const glm::dvec3 left = normal - (terms - abs_cross(corners.exact[from], corners.exact[to]));
    return {.terms = glm::dot(terms, {facts.largest_u, facts.largest_v, 1}),
            .least_slope = left.x / facts.scale.px_per_u + left.y / facts.scale.px_per_v};
}

/// The determinant's terms in absolute value.
double permanent(const std::array<glm::dvec3, 3>& corners) {
    return glm::dot(glm::abs(corners[0]), abs_cross(corners[1], corners[2]));
}

}  // namespace

HomogeneousBounds homogeneous_bounds(const ViewFacts& facts, const TriangleExtent& extent,
                                     const glm::dvec3& moved, const ZRange& z, double unit) {
    const CornersBeforeDivide corners(facts, extent, moved);
    const double of_six = gammas_of(unit)[6], terms = permanent(corners.largest);
    const double determinant =
        std::abs(glm::dot(corners.exact[0], glm::cross(corners.exact[1], corners.exact[2])));
    const double least = determinant - (terms - permanent(corners.exact)) - of_six * terms;
    HomogeneousBounds bounds;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const EdgeSize edge = edge_size(facts, corners, i);
        const double eps = edge.least_slope > 0 ? of_six * edge.terms / edge.least_slope : unlimited;
        // nothing lies farther from anything in the image
        bounds.edges_px[i] = std::min(eps, double(facts.view.width + facts.view.height));
        const double depth = std::abs(extent.size.depth[i]) + moved.z, slope = std::abs(z.per_inverse_depth);
        const double constant = std::abs(z.offset) / slope;
        sum += of_six * edge.terms * (facts.perspective ? 1 + constant * depth : constant + depth);
    }
    const double where_edge_on = terms > 0 ? unlimited : 0;  // 0 where all terms are zeros
    bounds.inverse_depth_error = least > 0 ? sum / least : where_edge_on;
    bounds.depth_factor = least > 0 ? of_six * terms / least : where_edge_on;
    return bounds;
}

}  // namespace zproof
