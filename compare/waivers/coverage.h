/// Which findings of a view the waivers cover.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/verdict.h"
#include "compare/waivers/waiver.h"

namespace zproof {

/// The view that is asked about.
struct WaivedView {
    std::string scene, view;
    std::string scene_sha256;
    Resolution size;
};

/// What came of a waiver on one view.
enum class WaiverEffect {
    holds,        ///< as many pixels as it allows: they pass
    fewer,        ///< fewer than it says, but some: they pass, and the waiver should shrink
    none,         ///< none: it does nothing here
    exceeded,     ///< more than it allows: none of them passes
    expired,      ///< it has run out: none passes
    other_scene,  ///< the scene is not the one that it was written for, or not the size: none passes
};

std::string_view name_of(WaiverEffect effect);

struct WaiverUse {
    std::string id;
    WaiverEffect effect = WaiverEffect::none;
    std::uint64_t matched = 0;  ///< defects of its classes in its place
    std::uint64_t waived = 0;   ///< of those, let pass on its word; the first waiver that holds speaks
};

/// What all waivers together did to the findings of one view.
struct WaiverCoverage {
    std::vector<std::optional<std::size_t>> by;  ///< per finding: the waiver that lets it pass
    std::vector<WaiverUse> uses;                 ///< of those that name this scene and view, in their order
};

/// Deterministic in all its arguments; knows no clock.
WaiverCoverage cover(std::span<const Waiver> waivers, const WaivedView& view,
                     std::span<const Finding> findings, Day today);

/// Does the waiver speak of this finding, leaving aside count, day and scene?
bool applies_to(const Waiver& waiver, const Finding& finding);

/// Does the text fit the pattern? * is any run of characters, ? is one.
bool fits(std::string_view pattern, std::string_view text);

}  // namespace zproof
