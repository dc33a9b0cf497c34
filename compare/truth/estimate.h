/// What polygons in double say of where an answer is seen: for statistics, and for where to look. It decides
/// nothing.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "compare/truth/admissible.h"

namespace zproof {

class Estimate {
  public:
    /// `gather` says what stands around the pixel of the answer at hand. It is asked once for each answer, if
    /// anything is.
    using Gather = std::function<Neighbourhood()>;
    Estimate(Gather gather, CoplanarMemory& coplanar) : gather_(std::move(gather)), coplanar_(coplanar) {}
    Estimate(const Estimate&) = delete;
    Estimate& operator=(const Estimate&) = delete;

    /// Turns to another answer; before, nothing may be asked.
    void turn_to(PrimitiveId answer) {
        answer_ = answer;
        set_.reset();
        around_.reset();
    }

    /// What stands around the pixel.
    const Neighbourhood& around();
    /// Is the answer seen in a square of that half-side?
    bool is_seen_within(double half_side_px);
    /// Places in such a square where the answer, a triangle, is truly visible: the middle of each part that
    /// others leave of it.
    std::vector<PixelOffset> places_seen(double half_side_px);

  private:
    AdmissibleSet<double>& set_within(double half_side_px);

    Gather gather_;
    CoplanarMemory& coplanar_;
    PrimitiveId answer_ = PrimitiveId::none;
    std::optional<Neighbourhood> around_;
    std::optional<AdmissibleSet<double>> set_;  ///< looks at around_
};

}  // namespace zproof
