#include "texture/footprint.h"

#include <cmath>

namespace zproof::texture {

namespace {

/// Quotient rule: d(U/W) = (dU - (U/W) dW) / W.
glm::dvec2 step(const Homography<double>& map, const glm::dvec2& place, double weight, bool in_x) {
    const auto along = [&](const Affine<double>& f) { return in_x ? f.a : f.b; };
    const glm::dvec2 change{along(map.u), along(map.v)};
    return (change - place * along(map.w)) / weight;
}

}  // namespace

Footprint footprint(const Homography<double>& map, int x, int y, Derivatives derivatives) {
    Footprint f{.centre_raster = {x + 0.5, y + 0.5}, .texels_from_raster = map};
    f.centre = f.at(f.centre_raster);
    if (derivatives == Derivatives::quad_differences) {
        const double left = (x & ~1) + 0.5, top = (y & ~1) + 0.5;
        f.per_x = f.at({left + 1, y + 0.5}) - f.at({left, y + 0.5});
        f.per_y = f.at({x + 0.5, top + 1}) - f.at({x + 0.5, top});
    } else {
        const double weight = map.w.at(f.centre_raster.x, f.centre_raster.y);
        f.per_x = step(map, f.centre, weight, true);
        f.per_y = step(map, f.centre, weight, false);
    }
    return f;
}

std::array<glm::dvec2, 4> corners(const Footprint& f) {
    const glm::dvec2 p = f.centre_raster;
    return {f.at(p + glm::dvec2{-0.5, -0.5}), f.at(p + glm::dvec2{0.5, -0.5}), f.at(p + glm::dvec2{0.5, 0.5}),
            f.at(p + glm::dvec2{-0.5, 0.5})};
}

Ellipse ellipse(const Footprint& f) {
    // J J^T = [a h; h c]; its eigenvalues are mean +- radius.
    const double a = f.per_x.x * f.per_x.x + f.per_y.x * f.per_y.x;
    const double c = f.per_x.y * f.per_x.y + f.per_y.y * f.per_y.y;
    const double h = f.per_x.x * f.per_x.y + f.per_y.x * f.per_y.y;
    const double mean = (a + c) / 2, radius = std::hypot((a - c) / 2, h);
    const double major = std::sqrt(mean + radius);
    const double area = std::abs(f.per_x.x * f.per_y.y - f.per_y.x * f.per_x.y);
    const double angle = std::atan2(2 * h, a - c) / 2;
    return {major, major > 0 ? area / major : 0, {std::cos(angle), std::sin(angle)}};
}

}  // namespace zproof::texture
