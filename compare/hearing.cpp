#include "compare/hearing.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <map>

#include "compare/displacement.h"

namespace zproof {

namespace {

/// In own eps. Few squares grow beyond it, and a triangle that is found and meets no square changes nothing.
constexpr double first_reach = 2;

}  // namespace

struct Hearing::Memories {
    std::map<const ViewBounds*, TriangleMemory> triangles;
    CoplanarMemory coplanar{4096};

    TriangleMemory& of(const ViewBounds* bounds) { return triangles.try_emplace(bounds, 1024).first->second; }
};

void Hearing::add(const ViewBounds& bounds, PrimitiveId answer, int x, int y) {
    pleas_.push_back({&bounds, answer, x, y, 0, pleas_.size()});
}

/// The squares that grow beyond their first reach are looked at once more with their full reach.
std::vector<Ruled> Hearing::hear(Asked asked) {
    std::vector<Ruled> rulings(pleas_.size());
    tbb::enumerable_thread_specific<Memories> memories;
    sites_.resize(pleas_.size());
    tbb::parallel_for(std::size_t(0), pleas_.size(), [&](std::size_t i) {
        Plea& plea = pleas_[i];
        plea.own_eps_px = own_eps_of(plea, memories.local());
        sites_[i] = {plea.x, plea.y, first_reach * plea.own_eps_px, {}};
    });
    while (!pleas_.empty()) {
        find_nearby_triangles(scene_, view_, sites_);
        std::vector<double> lacking(pleas_.size(), 0);
        tbb::parallel_for(std::size_t(0), pleas_.size(), [&](std::size_t i) {
            lacking[i] = try_to_hear(i, asked, memories.local(), rulings[pleas_[i].number]);
        });
        keep_lacking(lacking);
    }
    return rulings;
}

double Hearing::own_eps_of(const Plea& plea, Memories& memories) const {
    return own_eps_px(scene_, view_, *plea.bounds, plea.x, plea.y, plea.answer, memories.of(plea.bounds));
}

/// Decides the plea, or returns the reach that it needs.
double Hearing::try_to_hear(std::size_t i, Asked asked, Memories& memories, Ruled& ruled) const {
    const Plea& plea = pleas_[i];
    Neighbourhood around =
        neighbourhood_of(scene_, view_, *plea.bounds, sites_[i], plea.own_eps_px, memories.of(plea.bounds));
    if (around.eps_px > sites_[i].reach_px) return around.eps_px;
    if (amendment_) amendment_(around, plea.answer);
    ruled = {decide(around, plea.answer, memories.coplanar), around.eps_px, std::nullopt};
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
