/// Stories of pixels in two steps, so that one search of the scene can serve them and what is drawn beside
/// them.
#pragma once

#include <span>
#include <vector>

#include "compare/explanation/pixel_story.h"
#include "compare/rendered_frame.h"

namespace zproof {

class Storyteller {
  public:
    /// Everything must outlive it.
    Storyteller(const Scene& scene, const View& view, const RenderedFrame& candidate,
                const RenderedFrame& reference)
        : frames_{scene, view, {view, candidate}, {view, reference}} {}

    /// Stories without `candidates` and `background`, in order. Throws std::out_of_range for a place outside
    /// the view.
    std::vector<PixelStory> begin(std::span<const PixelPlace> places) const;
    /// `site` holds the triangles within the finding's eps_px.
    void finish(PixelStory& story, const Site& site) const;

  private:
    FramePair frames_;
};

/// Where a story's triangles are to be found: within its finding's eps_px, and at least within `reach_px`.
Site site_of(const PixelStory& story, double reach_px = 0);

}  // namespace zproof
