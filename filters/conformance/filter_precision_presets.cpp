#include "filters/conformance/filter_precision_presets.h"

#include <algorithm>
#include <array>

namespace zproof {

namespace {

/// Attributes and sums in float32: of a sum 80 roundings, weights included.
constexpr FilterPrecision float32_arithmetic{
    .arithmetic_bits = 24, .coordinate_bits = 24, .sum_bits = 24, .sum_roundings = 80, .colour_bits = 22};

/// Fractions of so many bits: of the place within a level, of the LOD, and of the taps of one lookup.
constexpr FilterPrecision with_fractions(double bits, double coordinate_bits) {
    FilterPrecision p = float32_arithmetic;
    p.coordinate_bits = coordinate_bits;
    p.weight_bits = p.lod_bits = p.tap_bits = bits;
    return p;
}

/// Vulkan 1.3, "Scale Factor Operation": for the length of a step an implementation may take what is at least
/// the larger of its coordinates, and at most the root of 2 times their sum. A length L has coordinates of
/// L / sqrt(2) and more, and of a sum up to sqrt(2) L: half a level less, or one level more.
constexpr FilterPrecision with_vulkan_lod(FilterPrecision p) {
    p.lod_below = 0.5;
    p.lod_above = 1;
    return p;
}

/// NVIDIA H200: the eight weights of a blend of two levels are multiples of 1/256, and each split is rounded
/// to the nearest (docs/oracles.md, "A graphics card").
constexpr FilterPrecision with_rounded_splits(FilterPrecision p) {
    p.split_bits = 9;
    return p;
}

/// Weights and tap places come of one or two further roundings.
constexpr FilterPrecision float32() {
    FilterPrecision p = float32_arithmetic;
    p.weight_bits = p.tap_bits = 22;
    return p;
}

/// It is handed coordinates in float32; what leads to them is the renderer's.
constexpr FilterPrecision oiio() {
    FilterPrecision p = float32();
    p.arithmetic_bits = FilterPrecision{}.arithmetic_bits;
    return p;
}

constexpr std::array known{
    FilterPrecisionPreset{
        "gpu", with_rounded_splits(with_fractions(8, 22)),
        "CUDA C++ Programming Guide, Linear Filtering: 9-bit fixed point with 8 bits of fraction; "
        "weights of a blend of two levels as measured on an NVIDIA H200"},
    FilterPrecisionPreset{"d3d11", with_fractions(8, 24),
                          "Direct3D 11.3, 7.18.5 and 7.18.16: D3D11_SUBTEXEL_FRACTIONAL_BIT_COUNT and "
                          "D3D11_MIP_LOD_FRACTIONAL_BIT_COUNT are 8"},
    FilterPrecisionPreset{
        "vulkan-min", with_vulkan_lod(with_fractions(4, 22)),
        "Vulkan 1.3, 33.1: subTexelPrecisionBits and mipmapPrecisionBits are at least 4; the "
        "LOD by its Scale Factor Operation"},
    FilterPrecisionPreset{"float32", float32(), "IEEE 754 binary32 throughout"},
    FilterPrecisionPreset{"float64", FilterPrecision{}, "IEEE 754 binary64, levels and picture in float32"},
    FilterPrecisionPreset{"oiio", oiio(), "OpenImageIO 2.4, TextureSystem: float32 throughout"},
};

}  // namespace

std::span<const FilterPrecisionPreset> filter_precision_presets() { return known; }

std::optional<FilterPrecision> preset_filter_precision(std::string_view name) {
    const auto found = std::ranges::find(known, name, &FilterPrecisionPreset::name);
    return found == known.end() ? std::nullopt : std::optional(found->precision);
}

}  // namespace zproof
