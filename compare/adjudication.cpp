#include "compare/adjudication.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "compare/nearby_triangles.h"

namespace zproof {

namespace {

/// One answer to be ruled on: where, whose, and what becomes of it.
struct Plea {
    const Witness* witness = nullptr;
    PrimitiveId answer = PrimitiveId::none;
    double own_eps_px = 0;
    Decision* decision = nullptr;
    double* eps_px = nullptr;
};

class Hearing {
  public:
    Hearing(const Scene& scene, const View& view) : scene_(scene), view_(view) {}

    void add(const Witness& witness, PrimitiveId answer, int x, int y, Decision& decision, double& eps_px) {
        const double own = own_eps_px(scene_, view_, witness.bounds(), x, y, answer);
        pleas_.push_back({&witness, answer, own, &decision, &eps_px});
        sites_.push_back({x, y, own, {}});
    }

    /// Most squares grow no further than their own eps; the others are looked at once more with their full
    /// reach.
    void hear() {
        while (!pleas_.empty()) {
            find_nearby_triangles(scene_, view_, sites_);
            std::vector<double> lacking(pleas_.size(), 0);
            tbb::parallel_for(std::size_t(0), pleas_.size(),
                              [&](std::size_t i) { lacking[i] = try_to_hear(i); });
            keep_lacking(lacking);
        }
    }

  private:
    /// Decides the plea, or returns the reach that it needs.
    double try_to_hear(std::size_t i) const {
        const Plea& plea = pleas_[i];
        const Neighbourhood around =
            neighbourhood_of(scene_, view_, plea.witness->bounds(), sites_[i], plea.own_eps_px);
        if (around.eps_px > sites_[i].reach_px) return around.eps_px;
        *plea.decision = decide(around, plea.answer);
        *plea.eps_px = around.eps_px;
        return 0;
    }

    void keep_lacking(const std::vector<double>& lacking) {
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

    const Scene& scene_;
    const View& view_;
    std::vector<Plea> pleas_;
    std::vector<Site> sites_;
};

}  // namespace

std::vector<Ruling> rule_on(const Scene& scene, const View& view, const Witness& candidate,
                            const Witness& reference, std::span<const OpenPixel> open) {
    std::vector<Ruling> rulings(open.size());
    Hearing hearing(scene, view);
    for (std::size_t i = 0; i < open.size(); ++i) {
        const Finding& f = open[i].finding;
        if (f.candidate.primitive == f.reference.primitive) continue;
        if (!open[i].candidate_invalid)
            hearing.add(candidate, f.candidate.primitive, f.x, f.y, rulings[i].candidate,
                        rulings[i].candidate_eps_px);
        if (!open[i].reference_invalid)
            hearing.add(reference, f.reference.primitive, f.x, f.y, rulings[i].reference,
                        rulings[i].reference_eps_px);
    }
    hearing.hear();
    return rulings;
}

PixelClass class_of(const OpenPixel& open, const Ruling& ruling) {
    if (open.candidate_invalid) return PixelClass::invalid;
    if (!is_lawful(ruling.candidate.standing))
        return class_of(ruling.candidate.standing, ruling.reference.standing);
    if (!open.candidate_depth_lawful) return PixelClass::wrong_depth;
    if (open.reference_invalid || !open.reference_depth_lawful) return PixelClass::reference_wrong;
    return class_of(ruling.candidate.standing, ruling.reference.standing);
}

}  // namespace zproof
