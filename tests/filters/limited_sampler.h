/// Samplers of limited precision, as hardware has them, for tests: honest ones, and ones with a small error.
#pragma once

#include "filters/conformance/filter_precision_presets.h"
#include "texture/method.h"

namespace zproof {

/// The preset gpu with lengths of steps that are not approximate, as these samplers have them.
inline FilterPrecision gpu_with_exact_lod() {
    FilterPrecision promise = *preset_filter_precision("gpu");
    promise.lod_below = promise.lod_above = 0;
    return promise;
}

enum class Rounding { nearest, down };

/// A number of so many bits behind the binary point, and something added; all of it where bits is infinite.
struct Lattice {
    double bits = std::numeric_limits<double>::infinity();
    Rounding rounding = Rounding::nearest;
    double offset = 0;

    double operator()(double x) const;
};

/// Trilinear by the longer step (trilinear-gl) of limited precision.
struct LimitedTrilinear {
    Lattice lod{}, weights{}, blend{};  ///< LOD; fraction within a level; fraction between levels
    Lattice splits{};            ///< of a level's share between columns, and of a column's between texels
    glm::dvec2 place_error{0};   ///< added to every place, texels of level 0
    double gain = 1;             ///< of what is shown
    bool is_float32 = true;      ///< texture coordinates are held in float32
    int half_levels_from = 100;  ///< levels from here on are kept as float16, made of those kept
};
/// As an NVIDIA H200 samples (docs/oracles.md), but for its lengths of steps.
inline LimitedTrilinear like_a_card() {
    constexpr Lattice eight{8};
    return {.lod = eight, .weights = eight, .blend = eight, .splits = eight};
}
texture::Method limited_trilinear(const LimitedTrilinear& parts);

/// Elliptical weighted averages (ewa-pbrt, ewa-pbrt-table) of limited precision.
struct LimitedEllipse {
    Lattice weights{};       ///< each weight
    int table_entries = 0;   ///< 0: the exponential itself
    bool is_clamped = true;  ///< the ratio of the axes, by the options' limit
};
texture::Method limited_ellipse(const LimitedEllipse& parts);

}  // namespace zproof
