#include "compare/explanation/explain.h"

#include <tbb/parallel_for.h>

#include "compare/explanation/explainer.h"

namespace zproof {

PixelExplanation explain(const Scene& scene, const View& view, const RenderedFrame& candidate,
                         const RenderedFrame& reference, const PixelCoord& place) {
    return explain(scene, view, candidate, reference, std::span(&place, 1)).front();
}

std::vector<PixelExplanation> explain(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                      const RenderedFrame& reference, std::span<const PixelCoord> places) {
    const Explainer explainer(scene, view, candidate, reference);
    std::vector<PixelExplanation> explanations = explainer.begin(places);
    std::vector<SearchPixel> search_pixels;
    for (const PixelExplanation& explanation : explanations)
        search_pixels.push_back(search_pixel_of(explanation));
    explainer.search(search_pixels);
    tbb::parallel_for(std::size_t(0), explanations.size(), [&](std::size_t i) {
        explainer.finish(explanations[i], search_pixels[i], Neighbourhood{}.most_work);
    });
    return explanations;
}

}  // namespace zproof
