#include "filters/methods/lod.h"

#include <algorithm>
#include <cmath>

namespace zproof::texture {

namespace {

double largest_entry(const Footprint& f) {
    return std::max({std::abs(f.per_x.x), std::abs(f.per_x.y), std::abs(f.per_y.x), std::abs(f.per_y.y)});
}

double spanned(const glm::dvec2& a, const glm::dvec2& b) { return std::abs(a.x * b.y - a.y * b.x); }

}  // namespace

double lod_gl_maximum(const Footprint& f) {
    return std::log2(std::max(glm::length(f.per_x), glm::length(f.per_y)));
}

double lod_ellipse_major(const Footprint& f) { return std::log2(ellipse(f).major); }

double lod_root_mean_square(const Footprint& f) {
    return std::log2((glm::dot(f.per_x, f.per_x) + glm::dot(f.per_y, f.per_y)) / 2) / 2;
}

double lod_area(const Footprint& f) { return std::log2(spanned(f.per_x, f.per_y)) / 2; }

double lod_chebyshev(const Footprint& f) { return std::log2(largest_entry(f)); }

double lod_pbrt(const Footprint& f) { return 1 + std::log2(largest_entry(f)); }

double lod_ray_cone(const Footprint& f) {
    return 1 + std::log2(spanned(f.cone.along, f.cone.across) / f.cone.cosine) / 2;
}

double lod_in_chain(double lod, const FilterOptions& options, std::size_t levels) {
    const double coarsest = double(levels) - 1, biased = lod + options.lod_bias;
    if (std::isnan(biased)) return coarsest;
    return std::clamp(std::min(std::max(biased, options.lod_min), options.lod_max), 0.0, coarsest);
}

int nearest_level(double lod_in_chain) { return std::max(0, int(std::ceil(lod_in_chain + 0.5)) - 1); }

}  // namespace zproof::texture
