#include "compare/admissible/displacement.h"

#include <algorithm>
#include <cmath>

#include "compare/admissible/admissible_set.h"
#include "compare/admissible/conservative.h"
#include "math/sign.h"

namespace zproof {

namespace {

/// Is the answer seen in squares around the pixel? By the conservative test; polygons in double say the rest.
class VisibleWithin {
  public:
    VisibleWithin(const Neighbourhood& around, PrimitiveId answer)
        : around_(around), answer_(answer), test_(around, answer) {}

    bool operator()(double half_side_px) {
        const ConservativeTest::Visibility seen = test_.seen_within(half_side_px);
        if (seen == ConservativeTest::Visibility::yes) return true;
        // the test knows nothing of gaps between triangles
        const bool is_certain = seen == ConservativeTest::Visibility::no && around_.is_watertight;
        return !is_certain && is_estimated(half_side_px);
    }
    /// Does a triangle meet the whole square?
    bool reaches() {
        return answer_ == PrimitiveId::none || set_of(around_.eps_px).reaches(*around_.index_of(answer_));
    }
    std::size_t work() const { return set_ ? set_->work() : 0; }

  private:
    bool is_estimated(double half_side_px) {
        AdmissibleSet<double>& set = set_of(half_side_px);
        if (answer_ == PrimitiveId::none) return set.holds_background(set.edge_rule());
        const std::optional<std::size_t> index = around_.index_of(answer_);
        return index && set.is_seen(*index);
    }
    AdmissibleSet<double>& set_of(double half_side_px) {
        if (!set_) set_.emplace(around_);
        set_->set_half_side(half_side_px);
        return *set_;
    }

    const Neighbourhood& around_;
    PrimitiveId answer_;
    ConservativeTest test_;
    std::optional<AdmissibleSet<double>> set_;
};

/// What is seen in a square is seen in every larger one: by bisection.
std::optional<double> least_displacement(VisibleWithin& seen_within, double eps_px) {
    const auto is_seen = [&](int step) { return seen_within(eps_px * step / displacement_steps); };
    if (is_seen(1)) return std::nullopt;
    int too_small = 1, enough = displacement_steps;
    while (enough - too_small > 1) {
        const int step = (too_small + enough) / 2;
        (is_seen(step) ? enough : too_small) = step;
    }
    if (enough == displacement_steps && !seen_within.reaches())
        return std::nullopt;  // shown by rounding alone
    return double(too_small) / displacement_steps;
}

}  // namespace

LeastDisplacement displacement_of(const Neighbourhood& around, PrimitiveId answer) {
    VisibleWithin seen_within(around, answer);
    try {
        const std::optional<double> over_eps = least_displacement(seen_within, around.eps_px);
        return {over_eps, seen_within.work()};
    } catch (const TooMuchWork&) {
        return {std::nullopt, seen_within.work()};
    }
}

}  // namespace zproof
