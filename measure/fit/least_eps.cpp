#include "measure/fit/least_eps.h"

#include <algorithm>
#include <cmath>

#include "compare/adjudicate/adjudicator.h"

namespace zproof::measure {
namespace {

/// Depth is left out of the rule: no triangle is in front of another for certain, and what reaches near or
/// far may lie on either side of it.
void admit_any_depth(Neighbourhood& around, PrimitiveId) {
    const Camera& camera = around.view.camera;
    for (Neighbour& n : around.neighbours) {
        n.least_inverse_depth = any_inverse_depth.least;
        n.greatest_inverse_depth = any_inverse_depth.greatest;
        if (n.nearest <= camera.near_depth) n.near_slack = unlimited;
        if (n.farthest >= camera.far_depth && std::isfinite(camera.far_depth)) n.far_slack = unlimited;
    }
}

RuleOverride override_of(const Allowance& allowance) {
    return allowance.depths == Allowance::Depths::any ? RuleOverride{admit_any_depth} : nullptr;
}

bool explains(Admissibility admissibility, Mesh mesh) {
    return is_admissible(admissibility) &&
           (mesh != Mesh::closed || admissibility != Admissibility::through_a_crack);
}

}  // namespace

double eps_px_at(int step) { return std::exp2(double(step) / steps_per_octave); }

std::vector<bool> PlaceRule::admit(std::span<const PixelAnswer> answers, double eps_px,
                                   const Allowance& allowance) const {
    const BoundedPrecision closed{.eps_px = eps_px, .depth_relative = allowance.depth_relative};
    BoundedPrecision gappy = closed;
    gappy.watertight = false;
    const ViewBounds of_closed(view_, closed), of_gappy(view_, gappy);
    std::vector<PixelQuery> queries;
    queries.reserve(answers.size());
    for (const PixelAnswer& a : answers)
        queries.push_back(
            {a.mesh == Mesh::with_gaps ? &of_gappy : &of_closed, a.answer.primitive, a.pixel.x, a.pixel.y});
    const Adjudicator adjudicator(scene_, view_, {&of_closed, &of_gappy}, QueryDetail::admissibility,
                                  override_of(allowance));
    const std::vector<QueryResult> results = adjudicator.decide(queries);
    std::vector<bool> admitted(answers.size());
    for (std::size_t i = 0; i < answers.size(); ++i)
        admitted[i] = explains(results[i].decision.admissibility, answers[i].mesh);
    return admitted;
}

std::vector<PixelAnswer> PlaceRule::inadmissible(std::span<const PixelAnswer> answers, double eps_px,
                                                 const Allowance& allowance) const {
    const std::vector<bool> admitted = admit(answers, eps_px, allowance);
    std::vector<PixelAnswer> left;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (!admitted[i]) left.push_back(answers[i]);
    return left;
}

/// What is admissible under one eps is so under every greater one.
std::vector<int> PlaceRule::octaves(std::span<const PixelAnswer> answers, const Allowance& allowance) const {
    std::vector<int> octaves(answers.size(), no_octave);
    std::vector<PixelAnswer> left(answers.begin(), answers.end());
    std::vector<std::size_t> places(answers.size());  // of what is left
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
    for (int octave = least_octave; octave <= most_octave && !left.empty(); ++octave) {
        const std::vector<bool> admitted = admit(left, std::ldexp(1.0, octave), allowance);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (admitted[i]) {
                octaves[places[i]] = octave;
                continue;
            }
            left[kept] = left[i];
            places[kept++] = places[i];
        }
        left.resize(kept);
    }
    return octaves;
}

LeastEps PlaceRule::least(std::span<const PixelAnswer> answers, std::span<const int> octaves,
                          const Allowance& allowance) const {
    if (answers.empty()) return {};
    const int octave = std::ranges::max(octaves);
    if (octave == least_octave) return {};
    std::vector<PixelAnswer> deciding;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (octaves[i] == octave) deciding.push_back(answers[i]);
    int low = (octave - 1) * steps_per_octave, high = octave * steps_per_octave;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        std::vector<PixelAnswer> left = inadmissible(deciding, eps_px_at(middle), allowance);
        (left.empty() ? high : low) = middle;
        if (!left.empty()) deciding = std::move(left);
    }
    LeastEps least{.px = {eps_px_at(low), eps_px_at(high)}, .decided_by = {}};
    for (const PixelAnswer& a : deciding) least.decided_by.push_back(a.pixel);
    return least;
}

}  // namespace zproof::measure
