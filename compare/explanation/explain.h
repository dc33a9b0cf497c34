/// The explanation of one pixel.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/explanation/pixel_explanation.h"
#include "compare/rendered_frame.h"

namespace zproof {

/// Judges one pixel and keeps the evidence. It must lie inside the view (std::out_of_range otherwise).
PixelExplanation explain(const Scene& scene, const View& view, const RenderedFrame& candidate,
                         const RenderedFrame& reference, const PixelCoord& place);

/// Explains many pixels of one view, in order, with few passes over the scene.
std::vector<PixelExplanation> explain(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                      const RenderedFrame& reference, std::span<const PixelCoord> places);

/// One sentence for a report: what was answered, what was expected, and why the verdict.
std::string in_words(const Scene& scene, const Finding& finding);

/// The explanation in full, several lines of plain text ending in a newline.
std::string in_words(const Scene& scene, const PixelExplanation& explanation);

}  // namespace zproof
