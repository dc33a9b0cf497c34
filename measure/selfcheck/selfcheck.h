/// Is a renderer at one with itself? It draws the same picture several times, told in other ways. No other
/// renderer takes part: where two of its frames differ, exact geometry decides which of them is admissible.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compare/verdict.h"
#include "measure/renderer.h"
#include "measure/selfcheck/variant.h"

namespace zproof::measure {

/// What became of one variant of one view.
struct VariantResult {
    std::string variant;
    ClassCounts counts{};                ///< of the variant's frames, held against the original's
    std::uint64_t defects = 0;           ///< pixels at which the variant's answer is inadmissible
    std::uint64_t original_defects = 0;  ///< pixels at which the original's is; 0 where numbers were rounded
    std::string first_defect;            ///< in words; empty where there is none
    bool was_drawn = true;               ///< false: the view has no such picture
};

/// Draws the view's variant, and judges it against the original's frame by the declared precision. An error
/// that both share is seen only where both have the same bits (docs/truth.md). Throws what the renderer
/// throws.
VariantResult check_variant(const Renderer& renderer, const Scene& scene, const View& view,
                            const Frame& original, const Variant& variant);

}  // namespace zproof::measure
