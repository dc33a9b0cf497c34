#include "compare/explanation/explain.h"

#include <tbb/parallel_for.h>

#include "compare/adjudicate/triangle_search.h"
#include "compare/explanation/storyteller.h"

namespace zproof {

PixelStory explain(const Scene& scene, const View& view, const RenderedFrame& candidate,
                   const RenderedFrame& reference, const PixelPlace& place) {
    return explain(scene, view, candidate, reference, std::span(&place, 1)).front();
}

std::vector<PixelStory> explain(const Scene& scene, const View& view, const RenderedFrame& candidate,
                                const RenderedFrame& reference, std::span<const PixelPlace> places) {
    const Storyteller teller(scene, view, candidate, reference);
    std::vector<PixelStory> stories = teller.begin(places);
    std::vector<Site> sites;
    for (const PixelStory& story : stories) sites.push_back(site_of(story));
    find_nearby_triangles(scene, view, sites);
    tbb::parallel_for(std::size_t(0), stories.size(),
                      [&](std::size_t i) { teller.finish(stories[i], sites[i]); });
    return stories;
}

}  // namespace zproof
