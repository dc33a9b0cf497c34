#include "filters/reference/surface_areas.h"

#include <algorithm>
#include <cmath>

#include "filters/reference/interval_image.h"
#include "filters/reference/seen_texture.h"
#include "math/rounding.h"

namespace zproof::oracle::filter_reference {

namespace {

using Polygon = std::vector<glm::dvec2>;

/// Sutherland and Hodgman 1974: what lies at most `at` along the axis, or at least.
Polygon half(const Polygon& polygon, int axis, double at, bool lower) {
    const auto inside = [&](const glm::dvec2& p) { return lower ? p[axis] <= at : p[axis] >= at; };
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        if (inside(p)) kept.push_back(p);
        if (inside(p) == inside(q)) continue;
        glm::dvec2 crossing = glm::mix(p, q, (at - p[axis]) / (q[axis] - p[axis]));
        crossing[axis] = at;
        kept.push_back(crossing);
    }
    return kept;
}

double area_of(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i] - polygon[0], q = polygon[(i + 1) % polygon.size()] - polygon[0];
        twice += p.x * q.y - q.x * p.y;
    }
    return std::abs(twice) / 2;
}

/// A square of whole texels, its side a power of 2.
struct Square {
    std::int64_t column, row, side;
};

/// A texel along an axis, and how often a run of whole numbers is wrapped to it.
struct Hit {
    std::size_t index;
    double times;
};

std::vector<Hit> hits(Wrap wrap, std::int64_t first, std::int64_t count, int size) {
    std::vector<Hit> all;
    const auto index = [&](std::int64_t i) { return std::size_t(wrapped_index(wrap, first + i, size)); };
    if (count <= size) {
        for (std::int64_t i = 0; i < count; ++i) all.push_back({index(i), 1});
        return all;
    }
    for (int i = 0; i < size; ++i) all.push_back({std::size_t(i), 0});
    for (std::int64_t i = 0; i < count; ++i) ++all[index(i)].times;
    return all;
}

/// Areas by texel, with what they may be off.
struct AreaMap {
    int width, height;
    std::vector<double> area, error;

    AreaMap(int w, int h) : width{w}, height{h}, area(std::size_t(w) * std::size_t(h)), error(area.size()) {}

    /// Each texel of the square is covered by this much, to within `off`.
    void add(const Square& square, const WrapRules& wrap, double covered, double off) {
        const std::vector<Hit> columns = hits(wrap.u, square.column, square.side, width);
        for (const Hit& row : hits(wrap.v, square.row, square.side, height))
            for (const Hit& column : columns) {
                const std::size_t at = row.index * std::size_t(width) + column.index;
                area[at] += row.times * column.times * covered;
                error[at] += row.times * column.times * off;
            }
    }
};

/// A triangle over its texels: area in the world by area on the texture, and what either may be off.
struct Shown {
    Polygon polygon;
    WrapRules wrap;
    double density = 0;
    double corner_error = 0;  ///< texels, along either axis
    double area_world = 0;
};

Shown shown(const Scene& scene, std::uint32_t triangle, const Texture& texture) {
    const TexturedTriangle t = textured_triangle(scene, triangle);
    Shown all{{}, {texture.sampler.wrap_u, texture.sampler.wrap_v}, 0, 0, 0};
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto place = texel_coordinates<double>(t, i);
        const auto terms = texel_coordinates<Magnitude>(t, i);
        all.polygon.emplace_back(place[0], place[1]);
        size = std::max({size, terms[0].value, terms[1].value});
    }
    // A corner has 4 roundings, and each of up to 22 cuts 4 more, theirs and ours.
    all.corner_error = gamma(256, 0x1p-53) * size;
    const glm::dvec3 p{t.corners_world[0]}, q{t.corners_world[1]}, r{t.corners_world[2]};
    all.area_world = glm::length(glm::cross(q - p, r - p)) / 2;
    all.density = all.area_world / area_of(all.polygon);
    return all;
}

/// Each of three edges that lies e beside its place, along either axis, takes at most sqrt(2) sqrt(2) e of a
/// texel.
void cover(const Shown& triangle, const Polygon& part, const Square& square, AreaMap& map) {
    if (part.size() < 3) return;
    const double off = 6 * triangle.density * triangle.corner_error, side = double(square.side);
    const double here = area_of(part);
    if (here == side * side) return map.add(square, triangle.wrap, triangle.density, off);
    if (square.side == 1) return map.add(square, triangle.wrap, triangle.density * here, off);
    const std::int64_t h = square.side / 2;
    for (const bool left : {true, false}) {
        const Polygon beside = half(part, 0, double(square.column + h), left);
        for (const bool upper : {true, false})
            cover(triangle, half(beside, 1, double(square.row + h), upper),
                  {square.column + (left ? 0 : h), square.row + (upper ? 0 : h), h}, map);
    }
}

/// The rule of docs/texture-filters.md, "Mip chains": wider than 2^20 texels, or beyond 2^40.
void add(const Shown& triangle, AreaMap& map) {
    if (!std::isfinite(triangle.density)) return;
    const auto [low_u, high_u] =
        std::minmax({triangle.polygon[0].x, triangle.polygon[1].x, triangle.polygon[2].x});
    const auto [low_v, high_v] =
        std::minmax({triangle.polygon[0].y, triangle.polygon[1].y, triangle.polygon[2].y});
    const double longest = std::max(high_u - low_u, high_v - low_v);
    if (longest > 0x1p20 || std::max({-low_u, high_u, -low_v, high_v}) > 0x1p40) {
        for (double& area : map.area) area += triangle.area_world / double(map.area.size());
        return;
    }
    std::int64_t side = 1;
    while (double(side) < longest + 2) side *= 2;
    cover(triangle, triangle.polygon,
          {std::int64_t(std::floor(low_u)), std::int64_t(std::floor(low_v)), side}, map);
}

}  // namespace

std::vector<Interval> area_shares(const Scene& scene, int image) {
    const Image& texels = scene.images[std::size_t(image)];
    AreaMap map{texels.width, texels.height};
    for (const Part& part : scene.parts) {
        const Material& material = scene.materials[std::size_t(part.material)];
        if (material.base_color.image != image || !is_textured(scene, material)) continue;
        for (std::uint32_t i = 0; i < part.triangle_count; ++i)
            add(shown(scene, part.first_triangle + i, material.base_color), map);
    }
    const auto most = std::ranges::max_element(map.area);
    if (!(*most > 0)) return {};
    // Sums over triangles and the quotients: a few thousand roundings at most.
    const auto within = [&](std::size_t i) {
        return widen(Interval{map.area[i]}, map.error[i] + 0x1p-40 * map.area[i]);
    };
    const Interval largest = within(std::size_t(most - map.area.begin()));
    std::vector<Interval> shares;
    for (std::size_t i = 0; i < map.area.size(); ++i) {
        const Interval share = clamped(within(i) / largest, 0, 1);
        shares.emplace_back(std::round(share.low() * 0x1p24) * 0x1p-24,
                            std::round(share.high() * 0x1p24) * 0x1p-24);
    }
    return shares;
}

}  // namespace zproof::oracle::filter_reference
