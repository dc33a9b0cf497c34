/// The one word said about a pixel, and all that the program knows of a word by itself.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace zproof {

/// The classes in order of severity: those that pass come first, and `invalid` stays last.
enum class PixelClass : std::uint8_t {
    agree,            ///< same id, depth within its bound
    edge,             ///< ids differ, both admissible: they meet at an edge within eps
    depth_tie,        ///< ids differ, both admissible, but only thanks to the depth bound
    abutting_edges,   ///< admissible only through a crack of the scene
    clip,             ///< ids differ, both admissible: they meet at the near or far plane
    reference_wrong,  ///< the reference's answer is inadmissible, the candidate's is not
    undecidable,      ///< more triangles within eps than the judge looks at: neither right nor wrong
    wrong_attribute,  ///< id and depth right, an interpolated value outside its bound
    wrong_depth,      ///< id right, depth outside its bound
    hole,             ///< background where the scene covers for certain
    outside,          ///< an id whose triangle does not reach the pixel
    hidden,           ///< an id that is occluded for certain
    invalid,          ///< no answer, so nothing to waive: NaN, id out of range ...
};
inline constexpr int pixel_class_count = int(PixelClass::invalid) + 1;

/// What a pixel of a class does to the gate.
enum class GateEffect : std::uint8_t {
    pass,
    undecided,  ///< neither: the view is not proven
    fail,
    fail_always,  ///< no waiver may speak of it
};

struct ClassFacts {
    std::string_view name;  ///< in reports and files
    GateEffect gate = GateEffect::pass;
    /// Heading of its column in the table of a run; none: its pixels are counted in another column, or agree.
    std::string_view column = {};
    /// 0xRRGGBB, of Okabe and Ito's palette (2008) and three tints. Blues are admissible ties, greens are
    /// flaws of the scene or the reference, warm colours and white are defects. Glyph and name say the same.
    std::uint32_t colour = 0;
    std::string_view glyph;    ///< one character wide
    std::string_view meaning;  ///< one sentence for strangers
};

/// The table. A class without a row does not compile.
// NOLINTNEXTLINE(readability-function-size): a table
constexpr ClassFacts facts_of(PixelClass c) {
    switch (c) {
        case PixelClass::agree:
            return {
                .name = "agree",
                .colour = 0x262A31,
                .glyph = "·",
                .meaning = "Both name the same triangle, and the depth lies within its bound.",
            };
        case PixelClass::edge:
            return {
                .name = "edge",
                .column = "edge",
                .colour = 0x56B4E9,
                .glyph = "/",
                .meaning =
                    "Two triangles meet here, closer than the rounding of an edge. Either answer is "
                    "admissible.",
            };
        case PixelClass::depth_tie:
            return {
                .name = "depth_tie",
                .column = "tie",
                .colour = 0x0072B2,
                .glyph = "≈",
                .meaning =
                    "Two surfaces lie closer in depth than the precision can tell. Either answer is "
                    "admissible.",
            };
        case PixelClass::abutting_edges:
            return {
                .name = "abutting_edges",
                .column = "abut",
                .colour = 0x009E73,
                .glyph = "┬",
                .meaning =
                    "A crack in the scene: surfaces touch here without sharing an edge. The answer is "
                    "admissible.",
            };
        case PixelClass::clip:
            return {
                .name = "clip",
                .column = "clip",
                .colour = 0x9AA0A8,
                .glyph = "|",
                .meaning = "A surface crosses the near or far plane here. Either answer is admissible.",
            };
        case PixelClass::reference_wrong:
            return {
                .name = "reference_wrong",
                .column = "ref",
                .colour = 0xB4E6D2,
                .glyph = "R",
                .meaning = "The reference gave an inadmissible answer, the candidate did not.",
            };
        case PixelClass::undecidable:
            return {
                .name = "undecidable",
                .gate = GateEffect::undecided,
                .column = "undec",
                .colour = 0x8C6BB1,
                .glyph = "?",
                .meaning =
                    "The declared precision is so coarse that too many triangles may be shown here. Nobody "
                    "can say.",
            };
        case PixelClass::wrong_attribute:
            return {
                .name = "wrong_attribute",
                .gate = GateEffect::fail,
                .colour = 0xF3B27A,
                .glyph = "≠",
                .meaning =
                    "Triangle and depth are right, but a value interpolated over it is outside its bound.",
            };
        case PixelClass::wrong_depth:
            return {
                .name = "wrong_depth",
                .gate = GateEffect::fail,
                .colour = 0xE69F00,
                .glyph = "↕",
                .meaning = "The right triangle, but its depth lies outside the bound.",
            };
        case PixelClass::hole:
            return {
                .name = "hole",
                .gate = GateEffect::fail,
                .colour = 0xD55E00,
                .glyph = "○",
                .meaning = "Background, where the scene covers the pixel for certain.",
            };
        case PixelClass::outside:
            return {
                .name = "outside",
                .gate = GateEffect::fail,
                .colour = 0xF0E442,
                .glyph = "◇",
                .meaning = "A triangle that does not reach this pixel.",
            };
        case PixelClass::hidden:
            return {
                .name = "hidden",
                .gate = GateEffect::fail,
                .colour = 0xCC79A7,
                .glyph = "▣",
                .meaning = "A triangle that lies behind another for certain.",
            };
        case PixelClass::invalid:
            return {
                .name = "invalid",
                .gate = GateEffect::fail_always,
                .colour = 0xFFFFFF,
                .glyph = "×",
                .meaning = "No answer: NaN, a negative depth outside its bound, no triangle of the scene.",
            };
    }
    return {};
}

constexpr bool passes(PixelClass c) { return facts_of(c).gate == GateEffect::pass; }
/// Does it fail the gate?
constexpr bool is_defect(PixelClass c) { return facts_of(c).gate >= GateEffect::fail; }
constexpr bool is_waivable(PixelClass c) { return facts_of(c).gate == GateEffect::fail; }
constexpr bool has_column(PixelClass c) { return !facts_of(c).column.empty(); }

/// The worse of two classes is the one with the larger value.
constexpr bool is_ordered_by_gate() {
    for (int i = 1; i < pixel_class_count; ++i)
        if (facts_of(PixelClass(i - 1)).gate > facts_of(PixelClass(i)).gate) return false;
    return true;
}
static_assert(is_ordered_by_gate());

/// The class's name in reports and files: "depth_tie".
constexpr std::string_view name_of(PixelClass c) { return facts_of(c).name; }

using ClassCounts = std::array<std::uint64_t, pixel_class_count>;

}  // namespace zproof
