/// A triangle that neither near nor far cuts, as it lies in the window.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compare/bounds/view_facts.h"

namespace zproof {

struct WindowTriangle {
    std::array<glm::dvec2, 3> corner_px;  ///< relative to the window's upper left corner

    /// |dx| + |dy| of each edge.
    std::array<double, 3> edges_px() const {
        std::array<double, 3> lengths;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 edge = glm::abs(corner_px[(i + 1) % 3] - corner_px[i]);
            lengths[i] = edge.x + edge.y;
        }
        return lengths;
    }
    /// The largest distance of a corner from the edge opposite, as the half-side of a square.
    double largest_height_px() const {
        const double least_edge = std::ranges::min(edges_px());
        return least_edge > 0 ? twice_area_px2() / least_edge : 0;
    }
    double twice_area_px2() const {
        const glm::dvec2 a = corner_px[1] - corner_px[0], b = corner_px[2] - corner_px[0];
        return std::abs(a.x * b.y - a.y * b.x);
    }
};

/// Relative to the window's upper left corner; perspective: of a corner before the eye.
inline glm::dvec2 corner_px(const ViewFacts& facts, const TriangleExtent& extent, std::size_t corner) {
    const Window& w = facts.view.camera.window;
    const glm::dvec2 at =
        facts.before_divide(extent, corner) / (facts.perspective ? extent.size.depth[corner] : 1.0);
    return {(at.x - w.left) * facts.scale.px_per_u, (w.top - at.y) * facts.scale.px_per_v};
}

inline std::optional<WindowTriangle> window_triangle(const ViewFacts& facts, const TriangleExtent& extent) {
    const Camera& c = facts.view.camera;
    WindowTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.size.depth[i];
        if (!(depth >= c.near_depth && depth <= c.far_depth)) return std::nullopt;
        triangle.corner_px[i] = corner_px(facts, extent, i);
    }
    return triangle;
}

}  // namespace zproof
