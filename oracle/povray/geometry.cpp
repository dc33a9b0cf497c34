#include "oracle/povray/geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "frame/number_text.h"
#include "oracle/oracle_error.h"
#include "oracle/povray/raster_box.h"
#include "oracle/povray/text.h"

namespace zproof::oracle {
namespace {

/// POV-Ray 3.7 sees nothing nearer to a ray's origin than 1e-4 (MIN_ISECT_DEPTH) and nothing farther than 1e7
/// (MAX_DISTANCE); its planes err by 1e-10 (EPSILON), which here is at most 1e-7 of the distance.
constexpr double nearest_hit = 1e-3, farthest_hit = 1e7;
/// The reach where those limits leave a choice: every ray meets boxes of more than 2e10 (INFINITE_VOLUME),
/// which takes time.
constexpr double usual_reach = 500;
constexpr std::size_t cluster_size = 4;
/// Relative error of a depth computed here: 3 products, 2 sums, the difference; with room.
constexpr double depth_error = 0x1p-48;

using Corners = std::array<glm::dvec3, 3>;

struct DepthRange {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

    void include(double depth, double error) {
        low = std::min(low, depth - error);
        high = std::max(high, depth + error);
    }
    void include(const DepthRange& other) {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }
    bool is_empty() const { return low > high; }
};

Corners corners_from_eye(const Scene& scene, const View& view, const glm::uvec3& triangle) {
    const auto from_eye = [&](std::uint32_t vertex) {
        return glm::dvec3(scene.vertices.position_world[vertex]) - glm::dvec3(view.camera.eye_world);
    };
    return {from_eye(triangle.x), from_eye(triangle.y), from_eye(triangle.z)};
}

DepthRange depth_range(const Corners& corners, const glm::dvec3& back) {
    DepthRange range;
    for (const glm::dvec3& corner : corners)
        range.include(-glm::dot(back, corner), depth_error * glm::dot(glm::abs(back), glm::abs(corner)));
    return range;
}

/// Where the sine at the second corner, at which POV-Ray computes the normal, is smaller, rounding may have
/// turned the normal anywhere: such a triangle is left out.
constexpr double least_corner_sine = 0x1p-26;

bool has_a_normal(const Corners& p) {
    const glm::dvec3 side1 = p[0] - p[1], side2 = p[2] - p[1];
    const double product = glm::length(side1) * glm::length(side2);
    return product > 0 && glm::length(glm::cross(side1, side2)) >= least_corner_sine * product;
}

struct VisibleTriangle {
    PovrayTriangle triangle;
    Cut cut;
    std::uint64_t place;  ///< neighbours in space have neighbouring places
};

struct VisibleTriangles {
    std::vector<VisibleTriangle> triangles;
    DepthRange depths;
};

VisibleTriangles visible_triangles(const Scene& scene, const View& view) {
    const double near = view.camera.near_depth, far = view.camera.far_depth;
    VisibleTriangles seen;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const Corners corners = corners_from_eye(scene, view, scene.triangles[i]);
        const DepthRange range = depth_range(corners, view.camera.back);
        if (range.high < near || range.low > far || !has_a_normal(corners)) continue;
        if (centres_around(corners, view, 1) == 0) continue;
        const Cut cut = range.low < near || range.high > far ? Cut::by_near_or_far : Cut::none;
        seen.triangles.push_back({{PrimitiveId{std::uint32_t(i)}, corners}, cut, 0});
        seen.depths.include(range);
    }
    return seen;
}

/// The depths that can be met, a little widened, so that no rounding leads out of them.
DepthRange met_depths(const DepthRange& depths, const Camera& camera) {
    if (depths.is_empty()) return {1, 2};
    const DepthRange met{std::max(depths.low, camera.near_depth), std::min(depths.high, camera.far_depth)};
    if (camera.projection == Projection::perspective)
        return {met.low * (1 - 0x1p-20), met.high * (1 + 0x1p-20)};
    const double widening =
        0x1p-20 * (met.high - met.low) + 0x1p-40 * std::max(std::abs(met.low), std::abs(met.high));
    return {met.low - widening, met.high + std::max(widening, std::numeric_limits<double>::min())};
}

double longest_direction(const Camera& camera) {
    const Window& w = camera.window;
    if (camera.projection == Projection::parallel) return std::hypot(camera.shear.x, camera.shear.y, 1.0);
    return std::hypot(std::max(std::abs(w.left), std::abs(w.right)),
                      std::max(std::abs(w.bottom), std::abs(w.top)), 1.0);
}

/// The power of two that brings the distances of all hits into POV-Ray's reach.
double scale_for(double nearest, double farthest) {
    return std::exp2(std::ceil(std::log2(std::max(usual_reach / farthest, nearest_hit / nearest))));
}

PovrayUnits units_of(const DepthRange& met, const View& view) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const bool perspective = c.projection == Projection::perspective;
    const double window_size = (w.right - w.left) + (w.top - w.bottom);
    const double start = perspective ? 0 : met.low - (met.high - met.low) - window_size;
    const double farthest = (met.high - start) * longest_direction(c);
    const double scale = scale_for(met.low - start, farthest);
    if (!(farthest * scale < farthest_hit))
        throw OracleError("POV-Ray: view '" + view.name + "' spans depths from " + shortest(met.low) +
                          " to " + shortest(met.high) +
                          ", expected a ratio below 1e9; bring near and far together");
    const double widest =
        std::max({std::abs(w.left), std::abs(w.right), std::abs(w.bottom), std::abs(w.top)});
    return {.scale = scale,
            .low = scale * met.low,
            .high = scale * met.high,
            .near = scale * c.near_depth,
            .far = scale * c.far_depth,
            .start = scale * start,
            .origin_reach = perspective ? 0 : scale * (2 * widest + std::abs(start) * longest_direction(c))};
}

/// Every third bit of the result, from the lowest.
std::uint64_t spread(std::uint64_t bits21) {
    std::uint64_t spread_bits = 0;
    for (int bit = 0; bit < 21; ++bit) spread_bits |= (bits21 >> bit & 1) << (3 * bit);
    return spread_bits;
}

/// The place of a point on a Z-curve (Morton, A computer oriented geodetic data base, 1966) through the cube
/// of half side `reach`.
std::uint64_t place_of(const glm::dvec3& point, double reach) {
    const auto step = [&](double coordinate) {
        return spread(std::uint64_t((std::clamp(coordinate / reach, -1.0, 1.0) + 1) * 0x1p20 * 0.999999));
    };
    return step(point.x) | step(point.y) << 1 | step(point.z) << 2;
}

/// Into POV-Ray's units, and in the order of clusters.
void arrange(std::vector<VisibleTriangle>& triangles, double scale) {
    for (VisibleTriangle& seen : triangles) {
        for (glm::dvec3& corner : seen.triangle.corner) corner *= scale;
        const Corners& p = seen.triangle.corner;
        seen.place = place_of((p[0] + p[1] + p[2]) / 3.0, 2 * usual_reach);
    }
    std::ranges::sort(triangles, {}, [](const VisibleTriangle& seen) {
        return std::tuple(seen.cut, seen.place, seen.triangle.primitive);
    });
}

void enclose(PovrayCluster& cluster, double origin_reach) {
    cluster.lowest = cluster.highest = cluster.triangles.front().corner[0];
    for (const PovrayTriangle& triangle : cluster.triangles)
        for (const glm::dvec3& corner : triangle.corner) {
            cluster.lowest = glm::min(cluster.lowest, corner);
            cluster.highest = glm::max(cluster.highest, corner);
        }
    const glm::dvec3 largest = glm::max(glm::abs(cluster.lowest), glm::abs(cluster.highest));
    const double margin = 0x1p-16 * (std::max({largest.x, largest.y, largest.z}) + origin_reach);
    cluster.lowest -= margin;
    cluster.highest += margin;
}

std::vector<PovrayCluster> clusters_of(const std::vector<VisibleTriangle>& triangles, double origin_reach) {
    std::vector<PovrayCluster> clusters;
    for (const VisibleTriangle& seen : triangles) {
        if (clusters.empty() || clusters.back().cut != seen.cut ||
            clusters.back().triangles.size() == cluster_size)
            clusters.push_back({.triangles = {}, .cut = seen.cut, .lowest = {}, .highest = {}});
        clusters.back().triangles.push_back(seen.triangle);
    }
    for (PovrayCluster& cluster : clusters) enclose(cluster, origin_reach);
    return clusters;
}

}  // namespace

PovrayGeometry povray_geometry(const Scene& scene, const View& view) {
    VisibleTriangles seen = visible_triangles(scene, view);
    const PovrayUnits units = units_of(met_depths(seen.depths, view.camera), view);
    arrange(seen.triangles, units.scale);
    return {units, clusters_of(seen.triangles, units.origin_reach)};
}

}  // namespace zproof::oracle
