/// The second tier: decides answers by the admissible set, in the surroundings that the scene gives them.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "compare/adjudicate/pixel_query.h"
#include "scenes/scene.h"

namespace zproof {

class TileWork;
/// What is to be done at one of many pixels: decides what there is to decide by the work of its tile, in
/// which all triangles within searched_px are known, and says 0. Otherwise the reach that it needs: it is
/// asked again with that.
using DoAtPixel = std::function<double(TileWork& work, std::size_t pixel, double searched_px)>;

/// Decides answers at the pixels of one view. It takes a pass over the scene whatever their number: put many
/// into one call.
class Adjudicator {
  public:
    /// `renderers`: the bounds of all queries. Everything must outlive it.
    Adjudicator(const Scene& scene, const View& view, std::vector<const ViewBounds*> renderers,
                QueryDetail asked, RuleOverride override = nullptr)
        : scene_(scene),
          view_(view),
          renderers_(std::move(renderers)),
          asked_(asked),
          override_(std::move(override)) {}

    /// Runs on all threads; one thread handles the pixels of a tile one after another. Leaves the rest undone
    /// where the surrounding task group is cancelled.
    void for_each_pixel(std::span<const PixelCoord> pixels, const DoAtPixel& act) const;
    /// All queries, in their order.
    std::vector<QueryResult> decide(std::span<const PixelQuery> queries) const;

  private:
    const Scene& scene_;
    const View& view_;
    std::vector<const ViewBounds*> renderers_;
    QueryDetail asked_;
    RuleOverride override_;
};

}  // namespace zproof
