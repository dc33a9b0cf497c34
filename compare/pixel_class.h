/// The one word said about a pixel, and which words fail the gate.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace zproof {

enum class PixelClass : std::uint8_t {
    agree,            ///< same id, depth within its bound
    edge,             ///< ids differ, both admissible: they meet at an edge within eps
    depth_tie,        ///< ids differ, both admissible, but only thanks to the depth bound
    abutting_edges,   ///< admissible only through a crack of the scene
    clip,             ///< ids differ, both admissible: they meet at the near or far plane
    reference_wrong,  ///< the reference's answer is inadmissible, the candidate's is not
    wrong_depth,      ///< id right, depth outside its bound
    hole,             ///< background where the scene covers for certain
    outside,          ///< an id whose triangle does not reach the pixel
    hidden,           ///< an id that is occluded for certain
    invalid,          ///< NaN, negative depth, id out of range, background with a depth
};
inline constexpr int pixel_class_count = 11;

/// Does the gate stay green? Everything from wrong_depth on fails it.
constexpr bool passes(PixelClass c) { return c < PixelClass::wrong_depth; }

/// Its name in reports and files: "depth_tie".
std::string_view name_of(PixelClass c);

using ClassCounts = std::array<std::uint64_t, pixel_class_count>;

}  // namespace zproof
