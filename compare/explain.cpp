#include "compare/explain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/adjudication.h"
#include "compare/nearby_triangles.h"

namespace zproof {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::array<double, 3> edge_distances(const Sight<double>& sight, const CornersWorld& p_world) {
    const auto image = image_of(sight, corners<double>(p_world));
    std::array<double, 3> distance{nan, nan, nan};
    for (std::size_t i = 0; image && i < 3; ++i) {
        const Affine<double>& edge = image->edge[i];
        distance[i] = 256 * edge.c / std::hypot(edge.a, edge.b);
    }
    return distance;
}

std::vector<Candidate> candidates_in(const View& view, const Witness& witness, const Neighbourhood& around) {
    const Sight<double> sight(view, around.x, around.y);
    std::vector<Candidate> candidates;
    for (const Neighbour& n : around.neighbours) {
        const Decision decision = decide(around, PrimitiveId(n.triangle));
        if (decision.standing == Standing::outside) continue;
        const TriangleDepth depth =
            depth_of(TriangleInView(view, witness.bounds(), n.p_world), witness.bounds());
        candidates.push_back({PrimitiveId(n.triangle), edge_distances(sight, n.p_world),
                              depth.at(around.x, around.y), decision});
    }
    std::ranges::stable_sort(candidates, {}, [](const Candidate& c) { return c.depth.truth; });
    return candidates;
}

/// A pixel before its surroundings are looked into: everything but `candidates` and `background`, and eps
/// only where the ids differ.
PixelStory told_so_far(const OpenPixel& open, const Ruling& ruling) {
    const bool same = open.finding.candidate.primitive == open.finding.reference.primitive;
    PixelStory story{open.finding,
                     ruling.candidate.decision,
                     ruling.reference.decision,
                     ruling.reference.eps_px,
                     !same,
                     {},
                     {}};
    story.finding.verdict = is_settled(open) ? PixelClass::agree : class_of(open, ruling);
    story.finding.eps_px = ruling.candidate.eps_px;
    return story;
}

void require_inside(const View& view, const PixelPlace& place) {
    if (place.x < 0 || place.y < 0 || place.x >= view.width || place.y >= view.height)
        throw std::out_of_range("explain: the pixel lies outside the view");
}

/// All that comes within each pixel's eps of its centre.
std::vector<Site> sites_of(const Scene& scene, const View& view, const std::vector<PixelStory>& stories) {
    std::vector<Site> sites;
    for (const PixelStory& story : stories)
        sites.push_back({story.finding.x, story.finding.y, story.finding.eps_px, {}});
    find_nearby_triangles(scene, view, sites);
    return sites;
}

}  // namespace

PixelStory explain(const Scene& scene, const View& view, const Testimony& candidate,
                   const Testimony& reference, int x, int y) {
    const PixelPlace place{x, y};
    return explain(scene, view, candidate, reference, std::span(&place, 1)).front();
}

std::vector<PixelStory> explain(const Scene& scene, const View& view, const Testimony& candidate,
                                const Testimony& reference, std::span<const PixelPlace> places) {
    const Witness ours(scene, view, candidate), theirs(scene, view, reference);
    std::vector<OpenPixel> open;
    PixelLook look(scene, ours, theirs);
    for (const PixelPlace& place : places) {
        require_inside(view, place);
        open.push_back(look.at(place.x, place.y));
    }
    const Rulings rulings = rule_on(scene, view, ours, theirs, places);
    std::vector<PixelStory> stories;
    for (std::size_t i = 0; i < open.size(); ++i) {
        stories.push_back(told_so_far(open[i], rulings[i]));
        Finding& f = stories[i].finding;
        if (!stories[i].ids_differ && !open[i].candidate_invalid)
            f.eps_px = own_eps_px(scene, view, ours.bounds(), f.x, f.y, f.candidate.primitive);
    }
    const std::vector<Site> sites = sites_of(scene, view, stories);
    for (std::size_t i = 0; i < stories.size(); ++i) {
        Neighbourhood around = neighbourhood_of(scene, view, ours.bounds(), sites[i], sites[i].reach_px);
        around.eps_px = sites[i].reach_px;
        stories[i].candidates = candidates_in(view, ours, around);
        stories[i].background = decide(around, PrimitiveId::none);
    }
    return stories;
}

}  // namespace zproof
