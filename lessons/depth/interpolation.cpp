#include "lessons/depth/interpolation.h"

#include <algorithm>

namespace zproof::study::depth {
namespace {

using Weights = std::array<float, 3>;

/// Sums in one fixed order, each product and sum rounded.
float blended(const Weights& weight, const std::array<float, 3>& value) {
    return (weight[0] * value[0] + weight[1] * value[1]) + weight[2] * value[2];
}

glm::dvec2 centre_of(Pixel p) { return {p.x + 0.5, p.y + 0.5}; }

Weights rounded_weights(const Drawn& triangle, Pixel p) {
    const std::array<double, 3> w = weights_at(triangle, centre_of(p));
    return {float(w[0]), float(w[1]), float(w[2])};
}

std::array<float, 3> coded(const Drawn& triangle, const Coder& coder) {
    const auto& d = triangle.depth;
    return {coder.of_depth(d[0]), coder.of_depth(d[1]), coder.of_depth(d[2])};
}

std::vector<float> stepped(const Drawn& triangle, std::span<const Pixel> pixels, const Coder& coder) {
    const Pixel start = start_of(pixels);
    const Plane3 plane = plane_through(triangle, coded(triangle, coder), start);
    const float per_x = float(plane.per_x), per_y = float(plane.per_y);
    std::vector<float> values;
    values.reserve(pixels.size());
    float row = float(plane.start), value = row;
    Pixel at = start;
    for (const Pixel p : pixels) {
        if (p.y != at.y) {
            for (; at.y < p.y; ++at.y) row += per_y;
            at.x = start.x;
            value = row;
        }
        for (; at.x < p.x; ++at.x) value += per_x;
        values.push_back(value);
    }
    return values;
}

}  // namespace

const char* name_of(Interpolation interpolation) {
    constexpr std::array names{"1/z", "ndc", "forward", "affine"};
    return names[std::size_t(interpolation)];
}

const char* definition_of(Interpolation interpolation) {
    constexpr std::array words{"1/d is interpolated with barycentrics, then coded pixel by pixel",
                               "the corners are coded, and that is interpolated with barycentrics",
                               "the corners are coded, and that is stepped: one addition per pixel and row",
                               "d itself is interpolated with barycentrics, then coded"};
    return words[std::size_t(interpolation)];
}

bool is_right_for(Interpolation interpolation, Coding coding) {
    switch (interpolation) {
        case Interpolation::reciprocal:
            return true;
        case Interpolation::ndc:
        case Interpolation::forward:
            return is_affine_in_image(coding);
        case Interpolation::affine:
            return false;
    }
    return false;
}

double Drawn::doubled_area() const {
    const glm::dvec2 a = p_raster[1] - p_raster[0], b = p_raster[2] - p_raster[0];
    return a.x * b.y - a.y * b.x;
}

std::array<double, 3> weights_at(const Drawn& triangle, const glm::dvec2& p_raster) {
    const auto edge = [&](int from, int to) {
        const glm::dvec2 a = triangle.p_raster[std::size_t(from)] - p_raster;
        const glm::dvec2 b = triangle.p_raster[std::size_t(to)] - p_raster;
        return a.x * b.y - a.y * b.x;
    };
    const double area = triangle.doubled_area();
    return {edge(1, 2) / area, edge(2, 0) / area, edge(0, 1) / area};
}

Pixel start_of(std::span<const Pixel> pixels) {
    Pixel first = pixels.front();
    for (const Pixel p : pixels) first.x = std::min(first.x, p.x);
    return first;
}

Plane3 plane_through(const Drawn& triangle, const std::array<float, 3>& s, Pixel at) {
    const auto value_at = [&](const glm::dvec2& p) {
        const auto w = weights_at(triangle, p);
        return w[0] * s[0] + w[1] * s[1] + w[2] * s[2];
    };
    const glm::dvec2 e1 = triangle.p_raster[1] - triangle.p_raster[0];
    const glm::dvec2 e2 = triangle.p_raster[2] - triangle.p_raster[0];
    const double rise1 = double(s[1]) - s[0], rise2 = double(s[2]) - s[0], area = triangle.doubled_area();
    return {value_at(centre_of(at)), (rise1 * e2.y - rise2 * e1.y) / area,
            (rise2 * e1.x - rise1 * e2.x) / area};
}

std::vector<float> interpolated(const Drawn& triangle, std::span<const Pixel> pixels, const Coder& coder,
                                Interpolation interpolation) {
    if (pixels.empty()) return {};
    if (interpolation == Interpolation::forward) return stepped(triangle, pixels, coder);
    const auto& d = triangle.depth;
    const std::array<float, 3> inverse{1 / d[0], 1 / d[1], 1 / d[2]}, s = coded(triangle, coder);
    std::vector<float> values;
    values.reserve(pixels.size());
    for (const Pixel p : pixels) {
        const Weights weight = rounded_weights(triangle, p);
        if (interpolation == Interpolation::reciprocal)
            values.push_back(coder.of_inverse(blended(weight, inverse)));
        else if (interpolation == Interpolation::affine)
            values.push_back(coder.of_depth(blended(weight, d)));
        else
            values.push_back(blended(weight, s));
    }
    return values;
}

}  // namespace zproof::study::depth
