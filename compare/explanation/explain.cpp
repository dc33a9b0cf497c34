#include "compare/explanation/explain.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "compare/explanation/storyteller.h"
#include "compare/hearing/adjudication.h"
#include "compare/search/nearby_triangles.h"

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

std::vector<Candidate> candidates_in(const View& view, const Witness& witness, const Neighbourhood& around,
                                     CoplanarMemory& memory) {
    const Sight<double> sight(view, around.x, around.y);
    std::vector<Candidate> candidates;
    for (const Neighbour& n : around.neighbours) {
        const Decision decision = decide(around, PrimitiveId(n.triangle), memory);
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

const RuledPlace* found_among(std::span<const RuledPlace> known, const PixelPlace& place) {
    const auto found =
        std::ranges::lower_bound(known, std::pair{place.y, place.x}, {}, [](const RuledPlace& r) {
            return std::pair{r.y, r.x};
        });
    return found != known.end() && found->x == place.x && found->y == place.y ? &*found : nullptr;
}

}  // namespace

PixelStory explain(const Scene& scene, const View& view, const Testimony& candidate,
                   const Testimony& reference, const PixelPlace& place) {
    return explain(scene, view, candidate, reference, std::span(&place, 1)).front();
}

std::vector<PixelStory> explain(const Scene& scene, const View& view, const Testimony& candidate,
                                const Testimony& reference, std::span<const PixelPlace> places) {
    const Storyteller teller(scene, view, candidate, reference);
    std::vector<PixelStory> stories = teller.begin(places);
    std::vector<Site> sites;
    for (const PixelStory& story : stories) sites.push_back(site_of(story));
    find_nearby_triangles(scene, view, sites);
    tbb::parallel_for(std::size_t(0), stories.size(),
                      [&](std::size_t i) { teller.finish(stories[i], sites[i]); });
    return stories;
}

std::vector<Ruling> Storyteller::rulings_on(std::span<const PixelPlace> places,
                                            std::span<const RuledPlace> known) const {
    std::vector<Ruling> rulings(places.size());
    std::vector<PixelPlace> unknown;
    std::vector<std::size_t> number;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (const RuledPlace* ruled = found_among(known, places[i])) {
            rulings[i] = {{ruled->candidate, ruled->candidate_eps_px, {}},
                          {ruled->reference, ruled->reference_eps_px, {}}};
        } else {
            unknown.push_back(places[i]);
            number.push_back(i);
        }
    }
    if (unknown.empty()) return rulings;
    const Rulings ruled = rule_on(scene_, view_, candidate_, reference_, unknown);
    for (std::size_t i = 0; i < unknown.size(); ++i) rulings[number[i]] = ruled[i];
    return rulings;
}

std::vector<PixelStory> Storyteller::begin(std::span<const PixelPlace> places,
                                           std::span<const RuledPlace> known) const {
    std::vector<OpenPixel> open;
    PixelLook look(scene_, candidate_, reference_);
    for (const PixelPlace& place : places) {
        require_inside(view_, place);
        open.push_back(look.at(place.x, place.y));
    }
    const std::vector<Ruling> rulings = rulings_on(places, known);
    std::vector<PixelStory> stories;
    for (std::size_t i = 0; i < open.size(); ++i) {
        stories.push_back(told_so_far(open[i], rulings[i]));
        Finding& f = stories[i].finding;
        if (!stories[i].ids_differ && !open[i].candidate_invalid)
            f.eps_px = own_eps_px(scene_, view_, candidate_.bounds(), {f.x, f.y}, f.candidate.primitive);
    }
    return stories;
}

void Storyteller::finish(PixelStory& story, const Site& site) const {
    Neighbourhood around = neighbourhood_of(scene_, view_, candidate_.bounds(), site, site.reach_px);
    around.eps_px = site.reach_px;
    CoplanarMemory memory(coplanar_pairs);
    story.candidates = candidates_in(view_, candidate_, around, memory);
    story.background = decide(around, PrimitiveId::none, memory);
}

Site site_of(const PixelStory& story, double reach_px) {
    const Finding& f = story.finding;
    return {f.x, f.y, std::max(f.eps_px, reach_px), {}};
}

}  // namespace zproof
