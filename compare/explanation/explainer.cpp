#include "compare/explanation/explainer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/adjudicate/pixel_check.h"
#include "compare/adjudicate/triangle_search.h"
#include "compare/adjudicate/unproven_pixels.h"
#include "compare/bounds/triangle_depth.h"

namespace zproof {

namespace {

constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();

std::array<double, 3> edge_distances(const ViewRay<double>& ray, const CornersWorld& p_world) {
    const auto image = image_of(ray, corners<double>(p_world));
    std::array<double, 3> distance{unmeasured, unmeasured, unmeasured};
    for (std::size_t i = 0; image && i < 3; ++i) {
        const Affine<double>& edge = image->edge[i];
        distance[i] = 256 * edge.c / std::hypot(edge.a, edge.b);
    }
    return distance;
}

/// Takes what a decision among so many takes at least, too: to bound four neighbours is worth a cut.
Decision decide_within(Neighbourhood& around, PrimitiveId answer) {
    const Decision decision = decide(around, answer);
    around.most_work -= std::min(around.most_work, decision.work + around.neighbours.size() / 4);
    return decision;
}

/// All triangles around, nearest first, not yet decided.
std::vector<Candidate> undecided_candidates(const View& view, const ViewBounds& shown,
                                            const Neighbourhood& around) {
    const ViewRay<double> ray(view, around.x, around.y);
    std::vector<Candidate> candidates;
    for (const Neighbour& n : around.neighbours) {
        const TriangleDepth depth(TriangleInView(view, shown, n.p_world), shown);
        candidates.push_back(
            {PrimitiveId(n.triangle), edge_distances(ray, n.p_world), depth.at(around.x, around.y), {}});
    }
    std::ranges::stable_sort(candidates, {}, [](const Candidate& c) { return c.depth.truth; });
    return candidates;
}

/// A pixel before its surroundings are looked into: everything but `candidates` and `background`.
PixelExplanation partial_explanation(const FramePair& frames, const PixelCheck& pixel,
                                     const PixelCoord& place) {
    PixelExplanation explanation{finding_of(frames, pixel, place),
                                 pixel.candidate_decision.decision,
                                 pixel.reference_decision.decision,
                                 pixel.ids_differ(),
                                 {},
                                 {}};
    if (!pixel.ids_differ() && !pixel.candidate.is_invalid)
        explanation.finding.eps_px = own_eps_px(frames.scene, frames.view, frames.candidate.bounds, place,
                                                pixel.candidate.answer.primitive);
    return explanation;
}

void require_inside(const View& view, const PixelCoord& place) {
    if (place.x < 0 || place.y < 0 || place.x >= view.width || place.y >= view.height)
        throw std::out_of_range("explain: the pixel lies outside the view");
}

}  // namespace

std::vector<PixelExplanation> Explainer::begin(std::span<const PixelCoord> places) const {
    for (const PixelCoord& place : places) require_inside(frames_.view, place);
    std::vector<UndecidedPixel> undecided;
    const std::vector<UndecidedPixel> of_first_tier =
        find_agreement(frames_, find_unproven_pixels(frames_), nullptr).undecided;
    for (const PixelCoord& place : places) {
        const auto found = std::ranges::find(of_first_tier, place, &UndecidedPixel::place);
        undecided.push_back({place, false, found != of_first_tier.end() && found->is_id_undecided});
    }
    std::vector<PixelExplanation> explanations(places.size());
    check_pixels(frames_, undecided, [&](std::size_t i, const PixelCheck& pixel) {
        explanations[i] = partial_explanation(frames_, pixel, places[i]);
    });
    return explanations;
}

void Explainer::search(std::span<SearchPixel> search_pixels) const {
    const ViewBounds* const renderers[] = {&frames_.candidate.bounds, &frames_.reference.bounds};
    find_nearby_triangles(frames_.scene, frames_.view, renderers, search_pixels);
}

void Explainer::finish(PixelExplanation& explanation, const SearchPixel& search_pixel,
                       std::size_t most_work) const {
    const auto& [scene, view, candidate, reference] = frames_;
    Neighbourhood around =
        neighbourhood_of(scene, view, candidate.bounds, search_pixel, search_pixel.reach_px);
    around.eps_px = search_pixel.reach_px;
    around.most_work = most_work;
    explanation.background = decide_within(around, PrimitiveId::none);
    std::vector<Candidate> near = undecided_candidates(view, candidate.shown_bounds, around);
    const auto ask = [&](Candidate& c) {
        if (around.most_work == 0) return false;
        c.decision = decide_within(around, c.primitive);
        return true;
    };
    const auto unasked = std::ranges::find_if_not(near, ask);
    explanation.left_out = std::size_t(near.end() - unasked);
    near.erase(unasked, near.end());
    std::erase_if(near,
                  [](const Candidate& c) { return c.decision.admissibility == Admissibility::outside; });
    explanation.candidates = std::move(near);
}

SearchPixel search_pixel_of(const PixelExplanation& explanation, double reach_px) {
    const Finding& f = explanation.finding;
    return {f.x, f.y, std::max(f.eps_px, reach_px), {}};
}

}  // namespace zproof
