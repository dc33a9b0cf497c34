#include "tests/attack/honest_modes.h"

#include <algorithm>

#include "frame/precision_presets.h"
#include "frame/precision_text.h"
#include "tests/attack/ray_casters.h"
#include "tests/precision/emulated_rasterizer.h"

namespace zproof::attack {

namespace {

using Modes = std::vector<HonestMode>;

/// A renderer that displaces triangles and depths as `limits` say.
HonestMode at_limits(const std::string& name, const Precision& precision, const Allowance& allowance,
                     const Limits& limits) {
    return {name + ", " + text_of(limits), precision, [allowance, limits](const Trial& trial) {
                const AttackScene& s = trial.scene();
                if (limits.plane_cut == PlaneCut::exact)
                    return draw_at_limits(trial.truth(), allowance, limits);
                const ExactScene cut(s.scene, s.view, planes_of(s.view, allowance, limits.plane_cut));
                return draw_at_limits(cut, allowance, limits);
            }};
}

void add_bounded(Modes& modes, const View& view, std::uint64_t seed) {
    for (const char* word :
         {"bounded,eps_px=0.00390625,depth_relative=2e-6",
          "bounded,eps_px=0.00390625,depth_relative=2e-6,watertight=false",
          "bounded,eps_px=0.3,depth_relative=1e-3", "bounded,eps_px=0.3,depth_relative=1e-3,watertight=false",
          "bounded,eps_px=1e-4,depth_relative=1e-5,depth_absolute=0.05"}) {
        const auto p = std::get<BoundedPrecision>(precision_from_word(word));
        for (const Movement movement :
             {Movement::one_way, Movement::any_corner, Movement::grow, Movement::shrink})
            for (const DepthError error : {DepthError::nearest, DepthError::farthest, DepthError::reversed}) {
                modes.push_back(at_limits(word, p, allowance_of(p, view),
                                          {.movement = movement,
                                           .sharing = p.watertight ? Sharing::alike : Sharing::apart,
                                           .depth_error = error,
                                           .edge_owner = EdgeOwner(seed % 3),
                                           .plane_cut = PlaneCut(seed / 3 % 3),
                                           .seed = seed}));
                ++seed;
            }
    }
}

/// Their transform rounds next to nothing, so that what the grid makes of corners is all that moves.
void add_snapped(Modes& modes, std::uint64_t seed) {
    const std::string exact = "raster,transform=float64,interpolation=float64";
    for (const char* keys :
         {"", ",subpixel_bits=4,watertight=false,depth_roundings=8", ",subpixel_bits=0,depth_roundings=100",
          ",subpixel_bits=4,snap=truncate", ",subpixel_bits=1,snap=truncate,watertight=false",
          ",subpixel_bits=12,snap=truncate,depth_roundings=1000"}) {
        const auto p = std::get<RasterPrecision>(precision_from_word(exact + keys));
        for (const DepthError error : {DepthError::nearest, DepthError::farthest, DepthError::reversed}) {
            modes.push_back(at_limits(
                exact + keys, p, allowance_of(p),
                {.movement = p.snap == Snap::nearest ? Movement::nearest_grid : Movement::beside_grid,
                 .sharing = p.watertight ? Sharing::alike : Sharing::apart,
                 .depth_error = error,
                 .edge_owner = EdgeOwner(seed % 3),
                 .seed = seed}));
            ++seed;
        }
    }
}

bool leaves_gaps(const RayPrecision& p) { return !p.watertight; }
bool leaves_gaps(const PlaneRayPrecision&) { return false; }

template <class P>
void add_cast(Modes& modes, const std::string& name, const P& p, std::uint64_t seed) {
    for (const Inside inside : {Inside::open, Inside::closed}) {
        // without a key of its own, a plane ray's test is a closed one
        if (inside == Inside::open && !leaves_gaps(p)) continue;
        const RayChoices choices{.inside = inside, .seed = seed};
        const std::string text =
            name + (inside == Inside::open ? ", open" : ", closed") + ", seed " + std::to_string(seed);
        modes.push_back({text, p, [p, choices](const Trial& trial) {
                             return cast(p, trial.scene().scene, trial.scene().view, choices);
                         }});
    }
}

void add_word(Modes& modes, const std::string& word, std::uint64_t seed) {
    const Precision precision = precision_from_word(word);
    if (const auto* raster = std::get_if<RasterPrecision>(&precision))
        modes.push_back({word, precision, [p = *raster](const Trial& trial) {
                             return emulate(p, trial.scene().scene, trial.scene().view);
                         }});
    if (const auto* ray = std::get_if<RayPrecision>(&precision)) add_cast(modes, word, *ray, seed);
    if (const auto* plane = std::get_if<PlaneRayPrecision>(&precision)) add_cast(modes, word, *plane, seed);
}

void add_rays(Modes& modes, std::uint64_t seed) {
    for (const std::string arithmetic : {"float32", "float64"})
        for (const std::string test : {"pluecker", "moeller_trumbore", "woop"}) {
            const std::string ray = "ray,arithmetic=" + arithmetic + ",test=" + test;
            for (const char* keys : {"", ",hit_point=barycentrics,watertight=false",
                                     ",aim_offset_px=0.01,direction_roundings=8,watertight=false",
                                     ",barycentric_tolerance=1e-3,world_absolute=1e-5"})
                add_word(modes, ray + keys, seed);
        }
    add_word(modes, "plane_ray", seed);
    add_word(modes, "plane_ray,aim_offset_px=0.02,depth_relative=1e-5", seed);
}

/// Rounded step by step as they are declared.
void add_rounded(Modes& modes, std::uint64_t seed) {
    for (const PrecisionPreset& preset : precision_presets()) add_word(modes, std::string(preset.name), seed);
    const std::string unsnapped = "raster,snap=none,watertight=false,edge_functions=";
    for (const char* keys :
         {"from_corner", "from_corner,edge_arithmetic=float64", "from_corner,barycentric_tolerance=1e-3",
          "from_corner,least_area_px2=1e-4,area_epsilon_px2=1e-4", "homogeneous"})
        add_word(modes, unsnapped + keys, seed);
    for (const char* word :
         {"raster", "raster,matrices=3", "raster,origin=eye", "raster,subpixel_bits=4,snap=truncate",
          "raster,depth_buffer=reversed_z", "raster,depth_buffer=reversed_z,linearization=float32"})
        add_word(modes, word, seed);
}

}  // namespace

std::vector<HonestMode> honest_modes(const View& view, std::uint64_t seed) {
    Modes modes;
    add_bounded(modes, view, seed);
    add_snapped(modes, seed);
    add_rays(modes, seed);
    add_rounded(modes, seed);
    return modes;
}

}  // namespace zproof::attack
