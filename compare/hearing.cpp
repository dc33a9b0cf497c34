#include "compare/hearing.h"

#include <tbb/parallel_for.h>

#include "compare/displacement.h"

namespace zproof {

void Hearing::add(const ViewBounds& bounds, PrimitiveId answer, int x, int y) {
    const double own = own_eps_px(scene_, view_, bounds, x, y, answer);
    pleas_.push_back({&bounds, answer, own, pleas_.size()});
    sites_.push_back({x, y, own, {}});
}

/// Most squares grow no further than their own eps; the others are looked at once more with their full
/// reach.
std::vector<Ruled> Hearing::hear(Asked asked) {
    std::vector<Ruled> rulings(pleas_.size());
    while (!pleas_.empty()) {
        find_nearby_triangles(scene_, view_, sites_);
        std::vector<double> lacking(pleas_.size(), 0);
        tbb::parallel_for(std::size_t(0), pleas_.size(), [&](std::size_t i) {
            lacking[i] = try_to_hear(i, asked, rulings[pleas_[i].number]);
        });
        keep_lacking(lacking);
    }
    return rulings;
}

/// Decides the plea, or returns the reach that it needs.
double Hearing::try_to_hear(std::size_t i, Asked asked, Ruled& ruled) const {
    const Plea& plea = pleas_[i];
    Neighbourhood around = neighbourhood_of(scene_, view_, *plea.bounds, sites_[i], plea.own_eps_px);
    if (around.eps_px > sites_[i].reach_px) return around.eps_px;
    if (amendment_) amendment_(around, plea.answer);
    ruled = {decide(around, plea.answer), around.eps_px, std::nullopt};
    if (asked == Asked::standing_and_displacement && ruled.decision.standing == Standing::visible)
        ruled.displacement_over_eps = displacement_over_eps(around, plea.answer);
    return 0;
}

void Hearing::keep_lacking(std::span<const double> lacking) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pleas_.size(); ++i) {
        if (lacking[i] == 0) continue;
        pleas_[kept] = pleas_[i];
        sites_[kept] = {sites_[i].x, sites_[i].y, lacking[i], {}};
        ++kept;
    }
    pleas_.resize(kept);
    sites_.resize(kept);
}

}  // namespace zproof
