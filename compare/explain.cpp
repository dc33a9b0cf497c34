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

/// Everything that comes within eps of the centre, or within a pixel's width if nothing has to come so near.
Neighbourhood surroundings(const Scene& scene, const View& view, const ViewBounds& bounds, const Finding& f,
                           double eps_px) {
    Site site{f.x, f.y, eps_px, {}};
    find_nearby_triangles(scene, view, std::span(&site, 1));
    Neighbourhood around = neighbourhood_of(scene, view, bounds, site, eps_px);
    around.eps_px = eps_px;
    return around;
}

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

}  // namespace

PixelStory explain(const Scene& scene, const View& view, const Testimony& candidate,
                   const Testimony& reference, int x, int y) {
    if (x < 0 || y < 0 || x >= view.width || y >= view.height)
        throw std::out_of_range("explain: the pixel lies outside the view");
    const Witness ours(scene, view, candidate), theirs(scene, view, reference);
    const OpenPixel open = open_pixel(scene, ours, theirs, x, y);
    const Ruling ruling = rule_on(scene, view, ours, theirs, std::span(&open, 1)).front();
    const bool same = open.finding.candidate.primitive == open.finding.reference.primitive;
    PixelStory story{open.finding,
                     ruling.candidate.decision,
                     ruling.reference.decision,
                     ruling.reference.eps_px,
                     !same,
                     {},
                     {}};
    story.finding.verdict = is_settled(open) ? PixelClass::agree : class_of(open, ruling);
    story.finding.eps_px =
        same ? own_eps_px(scene, view, ours.bounds(), x, y, open.finding.candidate.primitive)
             : ruling.candidate.eps_px;
    const Neighbourhood around =
        surroundings(scene, view, ours.bounds(), story.finding, story.finding.eps_px);
    story.candidates = candidates_in(view, ours, around);
    story.background = decide(around, PrimitiveId::none);
    return story;
}

}  // namespace zproof
