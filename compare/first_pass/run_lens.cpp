#include "compare/first_pass/run_lens.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace zproof {

namespace {

using strips::RunLens;

/// Places of coordinates are whole numbers of 32 bits, with a sign.
constexpr std::size_t most_things = std::size_t{1} << 29;

/// What may be read behind the last run.
constexpr std::size_t vector = strips::CornerPlaces::room - strips::CornerPlaces::most;

/// Where displacement, relative and absolute error are no less than what a side says: see docs/truth.md.
struct SideOf {
    std::optional<RunLens::Side> operator()(const std::monostate&) const { return std::nullopt; }
    std::optional<RunLens::Side> operator()(const RasterTerms& terms) const {
        return RunLens::Side{.eps_px = terms.base_px,
                             .factor = terms.factor,
                             .products = 0,
                             .of_corners = terms.transform,
                             .absolute = 0};
    }
    std::optional<RunLens::Side> operator()(const RayTerms& terms) const {
        return RunLens::Side{.eps_px = terms.aim_px,
                             .factor = terms.factor,
                             .products = terms.of_products,
                             .of_corners = terms.unit,
                             .absolute = terms.aim_absolute};
    }
};

std::optional<RunLens::Side> side_of(const Witness& witness) {
    const std::optional<RunLens::Side> side = std::visit(SideOf{}, witness.bounds().common_terms());
    if (!side) return std::nullopt;
    const double sum = side->eps_px + side->factor + side->products + side->of_corners + side->absolute;
    return std::isfinite(sum) ? side : std::nullopt;
}

/// What a displaced plane that ends at its corners' depths is displaced by, if it is that renderer's.
double kept_px(const Witness& witness, const RunLens::Side& side) {
    return witness.bounds().keeps_to_corners() ? side.eps_px : 0;
}

void put(const Vector3<double>& v, double (&numbers)[3]) {
    numbers[0] = v.x, numbers[1] = v.y, numbers[2] = v.z;
}

/// Asks for the memory in which they are.
[[gnu::always_inline]] inline void set_corners(const Scene& scene, std::size_t triangle,
                                               strips::CornerPlaces& corners, std::size_t place) {
    const glm::uvec3 vertices = scene.triangles[triangle];
    for (int i = 0; i < 3; ++i) {
        corners.of[i][place] = 3 * vertices[i];
        __builtin_prefetch(&scene.vertices.position_world[vertices[i]]);
    }
}
void fill_up(strips::CornerPlaces& corners, std::size_t count) {
    for (auto& places : corners.of) std::fill_n(places + count, vector, places[0]);
}

}  // namespace

std::optional<RunLens> run_lens_of(const Scene& scene, const Witness& candidate, const Witness& reference) {
    const View& view = candidate.view();
    const std::optional<RunLens::Side> ours = side_of(candidate), theirs = side_of(reference);
    const auto& p_world = scene.vertices.position_world;
    const bool is_addressable =
        !scene.triangles.empty() && scene.triangles.size() <= most_things && p_world.size() <= most_things;
    if (candidate.projection() != Projection::perspective || !ours || !theirs || !is_addressable)
        return std::nullopt;
    const Sight<double> first_pixel(view, 0, 0);
    const Gauge<double> gauge = candidate.bounds().gauge<double>();
    RunLens lens{.p_world = &p_world[0].x,
                 .width = double(view.width),
                 .height = double(view.height),
                 .near_depth = view.camera.near_depth,
                 .far_depth = view.camera.far_depth,
                 .kept_px = std::max(kept_px(candidate, *ours), kept_px(reference, *theirs)),
                 .candidate = *ours,
                 .reference = *theirs};
    put(gauge.eye, lens.eye);
    put(gauge.back, lens.back);
    put(first_pixel.direction, lens.direction);
    put(first_pixel.step_x, lens.step_x);
    put(first_pixel.step_y, lens.step_y);
    put(gauge.direction_abs, lens.direction_abs);
    return lens;
}

void fetch_triangles(const Scene& scene, const Strip& strip) {
    for (Strip::Pixels turns = strip.turns; turns != 0; turns &= turns - 1) {
        const PrimitiveId shown = strip.candidate.primitive[std::countr_zero(turns)];
        if (std::size_t(shown) < scene.triangles.size())
            __builtin_prefetch(&scene.triangles[std::size_t(shown)]);
    }
}

void set_runs(const Scene& scene, const Strip& strip, strips::Runs& runs) {
    runs.count = 0;
    runs.shown = runs.bare = 0;
    for (Strip::Pixels turns = strip.turns; turns != 0; ++runs.count) {
        const int first = std::countr_zero(turns);
        const Strip::Pixels run = Strip::take_run(turns);
        const PrimitiveId shown = strip.candidate.primitive[first];
        const bool is_triangle = std::size_t(shown) < scene.triangles.size();
        const auto k = std::size_t(runs.count);
        runs.first[k] = first;
        set_corners(scene, is_triangle ? std::size_t(shown) : 0, runs.corners, k);
        runs.shown |= Strip::Pixels{is_triangle} << k;
        if (shown == PrimitiveId::none) runs.bare |= run;
    }
    std::fill_n(runs.first + runs.count, vector, int(Strip::width));
    fill_up(runs.corners, std::size_t(runs.count));
}

void set_tolerances(const strips::Kernel& kernel, const RunLens& lens, const Scene& scene,
                    const TrianglesInTile& of, std::span<DepthTolerance> tolerances) {
    const auto& [triangles, tile] = of;
    for (const PrimitiveId triangle : triangles) __builtin_prefetch(&scene.triangles[std::size_t(triangle)]);
    strips::CornerPlaces corners;
    for (std::size_t first = 0; first < triangles.size(); first += corners.most) {
        const std::size_t count = std::min(triangles.size() - first, std::size_t(corners.most));
        for (std::size_t i = 0; i < count; ++i)
            set_corners(scene, std::size_t(triangles[first + i]), corners, i);
        fill_up(corners, count);
        kernel.set_tolerances(lens, corners, int(count), tile, &tolerances[first]);
    }
}

}  // namespace zproof
