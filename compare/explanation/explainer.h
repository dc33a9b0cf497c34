/// Explanations of pixels in two steps, so that one search of the scene can serve them and what is drawn
/// beside them.
#pragma once

#include <span>
#include <vector>

#include "compare/explanation/pixel_explanation.h"
#include "compare/rendered_frame.h"

namespace zproof {

class Explainer {
  public:
    /// Everything must outlive it.
    Explainer(const Scene& scene, const View& view, const RenderedFrame& candidate,
              const RenderedFrame& reference)
        : frames_{scene, view, {view, candidate}, {view, reference}} {}

    /// Explanations without `candidates` and `background`, in order. Throws std::out_of_range for a place
    /// outside the view.
    std::vector<PixelExplanation> begin(std::span<const PixelCoord> places) const;
    /// The triangles near pixels, by the bounds of both renderers.
    void search(std::span<SearchPixel> search_pixels) const;
    /// `search_pixel` holds the triangles within the finding's eps_px. At most `most_work` is spent, in cuts
    /// of a region by a half-plane: on background first, then from the nearest triangle on.
    void finish(PixelExplanation& explanation, const SearchPixel& search_pixel, std::size_t most_work) const;

  private:
    FramePair frames_;
};

/// The search for an explanation's triangles: within its finding's eps_px, and at least within `reach_px`.
SearchPixel search_pixel_of(const PixelExplanation& explanation, double reach_px = 0);

}  // namespace zproof
