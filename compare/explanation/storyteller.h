/// Stories of pixels in two steps, so that one search of the scene can serve them and what is drawn beside
/// them.
#pragma once

#include "compare/explanation/explain.h"
#include "compare/hearing/adjudication.h"
#include "compare/judge_in_full.h"
#include "compare/witness.h"

namespace zproof {

class Storyteller {
  public:
    /// Everything must outlive it.
    Storyteller(const Scene& scene, const View& view, const Testimony& candidate, const Testimony& reference)
        : scene_(scene),
          view_(view),
          candidate_(scene, view, candidate),
          reference_(scene, view, reference) {}

    /// Stories without `candidates` and `background`, in order. What is among the `known` rulings, which
    /// stand in raster order, is not ruled on again. Throws std::out_of_range for a place outside the view.
    std::vector<PixelStory> begin(std::span<const PixelPlace> places,
                                  std::span<const RuledPlace> known = {}) const;
    /// `site` holds the triangles within the finding's eps_px.
    void finish(PixelStory& story, const Site& site) const;

  private:
    std::vector<Ruling> rulings_on(std::span<const PixelPlace> places,
                                   std::span<const RuledPlace> known) const;

    const Scene& scene_;
    const View& view_;
    Witness candidate_, reference_;
};

/// Where a story's triangles are to be found: within its finding's eps_px, and at least within `reach_px`.
Site site_of(const PixelStory& story, double reach_px = 0);

}  // namespace zproof
