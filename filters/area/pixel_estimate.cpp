#include "filters/area/pixel_estimate.h"

#include <algorithm>
#include <cmath>

namespace zproof::oracle::area {

namespace {

constexpr int replicates = ScrambledPoints::replicates;
constexpr double student_15 = 2.131449545559323;  ///< t of 15 degrees of freedom, two-sided 95 %
constexpr double fine_enough = 0.001;

using Sums = std::array<glm::dvec3, std::size_t(replicates)>;

/// No sample's weight is greater than `greatest`.
Estimate estimate_from(const Sums& sums, int points, double greatest) {
    glm::dvec3 mean(0), squares(0);
    for (const glm::dvec3& sum : sums) mean += sum / double(points);
    mean /= double(replicates);
    for (const glm::dvec3& sum : sums) {
        const glm::dvec3 deviation = sum / double(points) - mean;
        squares += deviation * deviation;
    }
    const double worst = std::max({squares.r, squares.g, squares.b});
    const double student = student_15 * std::sqrt(worst / (replicates * (replicates - 1)));
    return {mean, std::max(student, 3 * greatest / (replicates * points))};
}

std::int64_t whole(double place) { return std::int64_t(std::floor(place)); }

glm::dvec3 nearest_at(const SurfaceColour& colour, double u, double v) {
    return colour.texel(colour.column(whole(u)), colour.row(whole(v)));
}

glm::dvec3 bilinear_at(const SurfaceColour& colour, double u, double v) {
    const std::int64_t k = whole(u - 0.5), l = whole(v - 0.5);
    const double s = u - 0.5 - double(k), t = v - 0.5 - double(l);
    const int left = colour.column(k), right = colour.column(k + 1);
    const auto row = [&](int r) { return (1 - s) * colour.texel(left, r) + s * colour.texel(right, r); };
    return (1 - t) * row(colour.row(l)) + t * row(colour.row(l + 1));
}

}  // namespace

glm::dvec3 PixelEstimator::colour(std::uint32_t triangle, const glm::dvec2& p_raster) const {
    const SurfaceColour& colour = surfaces_.colour(triangle);
    const auto& seen = surfaces_.seen(triangle);
    if (colour.image == nullptr || !seen) return colour.factor;
    const auto [u, v] = seen->texels.at(p_raster.x, p_raster.y);
    if (!(std::abs(u) < 0x1p52 && std::abs(v) < 0x1p52)) return glm::dvec3(0);
    return colour.factor *
           (is_of_nearest(reconstruction_) ? nearest_at(colour, u, v) : bilinear_at(colour, u, v));
}

void PixelEstimator::add(Sums& sums, glm::ivec2 pixel, int first, int last) const {
    std::vector<glm::dvec2> places;
    std::vector<double> weights;
    for (int r = 0; r < replicates; ++r) {
        const glm::u32vec2 shift = ScrambledPoints::shift(pixel.x, pixel.y, r);
        for (int i = first; i < last; ++i) {
            const Draw draw = weight_.drawn(points_.at(r, i, shift));
            places.push_back(glm::dvec2(pixel) + 0.5 + draw.offset_px);
            weights.push_back(draw.weight);
        }
    }
    const std::vector<PrimitiveId> met = embree_.met(view_, places);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (met[i] != PrimitiveId::none)
            sums[i / std::size_t(last - first)] += weights[i] * colour(std::uint32_t(met[i]), places[i]);
}

Estimate PixelEstimator::at(int x, int y) const {
    Sums sums{};
    for (int done = 0, points = 16;; done = points, points *= 2) {
        add(sums, {x, y}, done, points);
        const Estimate estimate = estimate_from(sums, points, weight_.greatest_draw);
        if (estimate.half_width <= fine_enough || points == ScrambledPoints::most_points) return estimate;
    }
}

}  // namespace zproof::oracle::area
