#include "compare/explanation/storyteller.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/adjudicate/pixel_check.h"
#include "compare/adjudicate/triangle_search.h"
#include "compare/bounds/triangle_depth.h"

namespace zproof {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Remembered at one pixel.
constexpr std::size_t coplanar_pairs = 64;

std::array<double, 3> edge_distances(const Sight<double>& sight, const CornersWorld& p_world) {
    const auto image = image_of(sight, corners<double>(p_world));
    std::array<double, 3> distance{nan, nan, nan};
    for (std::size_t i = 0; image && i < 3; ++i) {
        const Affine<double>& edge = image->edge[i];
        distance[i] = 256 * edge.c / std::hypot(edge.a, edge.b);
    }
    return distance;
}

std::vector<Candidate> candidates_in(const View& view, const ViewBounds& bounds, const Neighbourhood& around,
                                     CoplanarMemory& coplanar) {
    const Sight<double> sight(view, around.x, around.y);
    std::vector<Candidate> candidates;
    for (const Neighbour& n : around.neighbours) {
        const Decision decision = decide(around, PrimitiveId(n.triangle), coplanar);
        if (decision.admissibility == Admissibility::outside) continue;
        const TriangleDepth depth(TriangleInView(view, bounds, n.p_world), bounds);
        candidates.push_back({PrimitiveId(n.triangle), edge_distances(sight, n.p_world),
                              depth.at(around.x, around.y), decision});
    }
    std::ranges::stable_sort(candidates, {}, [](const Candidate& c) { return c.depth.truth; });
    return candidates;
}

/// A pixel before its surroundings are looked into: everything but `candidates` and `background`.
PixelStory told_so_far(const FramePair& frames, const PixelCheck& pixel, const PixelPlace& place) {
    PixelStory story{finding_of(frames, pixel, place),
                     pixel.candidate_decision.decision,
                     pixel.reference_decision.decision,
                     pixel.ids_differ(),
                     {},
                     {}};
    if (!pixel.ids_differ() && !pixel.candidate.is_invalid)
        story.finding.eps_px = own_eps_px(frames.scene, frames.view, frames.candidate.bounds, place,
                                          pixel.candidate.answer.primitive);
    return story;
}

void require_inside(const View& view, const PixelPlace& place) {
    if (place.x < 0 || place.y < 0 || place.x >= view.width || place.y >= view.height)
        throw std::out_of_range("explain: the pixel lies outside the view");
}

}  // namespace

std::vector<PixelStory> Storyteller::begin(std::span<const PixelPlace> places) const {
    for (const PixelPlace& place : places) require_inside(frames_.view, place);
    std::vector<UndecidedPixel> undecided;
    for (const PixelPlace& place : places) undecided.push_back({place});
    std::vector<PixelStory> stories(places.size());
    check_pixels(frames_, undecided, [&](std::size_t i, const PixelCheck& pixel) {
        stories[i] = told_so_far(frames_, pixel, places[i]);
    });
    return stories;
}

void Storyteller::finish(PixelStory& story, const Site& site) const {
    const auto& [scene, view, candidate, reference] = frames_;
    Neighbourhood around = neighbourhood_of(scene, view, candidate.bounds, site, site.reach_px);
    around.eps_px = site.reach_px;
    CoplanarMemory coplanar(coplanar_pairs);
    story.candidates = candidates_in(view, candidate.bounds, around, coplanar);
    story.background = decide(around, PrimitiveId::none, coplanar);
}

Site site_of(const PixelStory& story, double reach_px) {
    const Finding& f = story.finding;
    return {f.x, f.y, std::max(f.eps_px, reach_px), {}};
}

}  // namespace zproof
