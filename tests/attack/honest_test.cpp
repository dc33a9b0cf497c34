/// Adversarial honesty: whoever keeps its promise at the limits is proven.
#include <gtest/gtest.h>

#include "tests/attack/trial.h"

namespace zproof::attack {
namespace {

struct Promise {
    std::string name;
    Precision precision;
    Allowance allowance;
};

Promise bounded(const std::string& name, const View& view, double eps_px, double share, double units,
                bool is_watertight) {
    const BoundedPrecision p{
        .eps_px = eps_px, .depth_relative = share, .depth_absolute = units, .watertight = is_watertight};
    return {name, p, allowance_of(p, view)};
}

Promise raster(const std::string& name, int bits, Snap snap, bool is_watertight, int roundings) {
    const RasterPrecision p{.transform = Arithmetic::float64,
                            .subpixel_bits = bits,
                            .snap = snap,
                            .watertight = is_watertight,
                            .interpolation = Arithmetic::float64,
                            .depth_roundings = roundings};
    return {name, p, allowance_of(p)};
}

std::vector<Promise> promises(const View& view) {
    return {bounded("bounded 1/256", view, 0x1p-8, 2e-6, 0, true),
            bounded("bounded 1/256 apart", view, 0x1p-8, 2e-6, 0, false),
            bounded("bounded 0.3", view, 0.3, 1e-3, 0, true),
            bounded("bounded 0.3 apart", view, 0.3, 1e-3, 0, false),
            bounded("bounded depth", view, 1e-4, 1e-5, 0.05, true),
            raster("raster 8", 8, Snap::nearest, true, 2),
            raster("raster 4", 4, Snap::nearest, false, 8),
            raster("raster 4 truncating", 4, Snap::truncate, true, 2),
            raster("raster 1 truncating apart", 1, Snap::truncate, false, 2)};
}

std::vector<Movement> movements_of(const Precision& precision) {
    using enum Movement;
    if (const auto* p = std::get_if<RasterPrecision>(&precision))
        return {p->snap == Snap::nearest ? nearest_grid : beside_grid};
    return {one_way, any_corner, grow, shrink};
}

std::vector<Limits> ways_to_keep(const Precision& precision, std::uint64_t seed) {
    const bool is_watertight = std::visit(
        [](const auto& p) {
            if constexpr (requires { p.watertight; }) return p.watertight;
            return false;
        },
        precision);
    // a float64 transform cuts where near and far are, but for what rounds in float64
    const bool is_raster = std::holds_alternative<RasterPrecision>(precision);
    std::vector<Limits> ways;
    for (const Movement movement : movements_of(precision))
        for (const DepthError error : {DepthError::nearest, DepthError::farthest, DepthError::reversed}) {
            Limits limits{.movement = movement,
                          .sharing = is_watertight ? Sharing::alike : Sharing::apart,
                          .depth_error = error,
                          .edge_owner = EdgeOwner(seed % 3),
                          .plane_cut = is_raster ? PlaneCut::exact : PlaneCut(seed / 3 % 3),
                          .seed = seed};
            ways.push_back(limits);
            ++seed;
        }
    return ways;
}

/// Over many scenes.
struct Count {
    std::uint64_t frames = 0, pixels = 0, defects = 0, undecidable = 0;
};

void hold(const AttackScene& scene, std::uint64_t seed, Count& count) {
    const Trial trial(scene);
    for (const Promise& promise : promises(scene.view)) {
        for (const Limits& limits : ways_to_keep(promise.precision, seed)) {
            const ExactScene cut(scene.scene, scene.view,
                                 planes_of(scene.view, promise.allowance, limits.plane_cut));
            const Verdict verdict =
                trial.judge_of(draw_at_limits(cut, promise.allowance, limits), promise.precision);
            ++count.frames;
            count.pixels += std::uint64_t(scene.view.width * scene.view.height);
            count.defects += defect_count(verdict);
            count.undecidable += undecidable_count(verdict);
            EXPECT_EQ(defect_count(verdict), 0u) << scene.name << ", " << promise.name << ", "
                                                 << text_of(limits) << ": " << first_defect(verdict);
        }
        seed += 7;
    }
}

TEST(AdversarialHonesty, OfHandMadeScenes) {
    Count count;
    for (const AttackScene& scene : hand_made_scenes()) hold(scene, 1, count);
    std::printf("%lu frames %lu pixels %lu defects %lu undecidable\n", count.frames, count.pixels,
                count.defects, count.undecidable);
}

TEST(AdversarialHonesty, OfRandomScenes) {
    Count count;
    for (std::uint64_t n = 0; n < 36; ++n) {
        const AttackScene scene = random_attack_scene(60, n);
        if (scene.scene.triangles.size() > 150) continue;
        hold(scene, n, count);
    }
    std::printf("%lu frames %lu pixels %lu defects %lu undecidable\n", count.frames, count.pixels,
                count.defects, count.undecidable);
}

}  // namespace
}  // namespace zproof::attack
