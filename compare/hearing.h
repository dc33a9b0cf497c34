/// Answers heard together: each is decided by the admissible set, in the surroundings that the scene gives
/// it.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "compare/ruled.h"
#include "scenes/scene.h"

namespace zproof {

/// Changes what stands around an answer before it is decided: another rule of drawing than the law.
using Amendment = std::function<void(Neighbourhood& around, PrimitiveId answer)>;

/// Hearings take a pass over the scene whatever their number: put many answers into one.
class Hearing {
  public:
    Hearing(const Scene& scene, const View& view, Amendment amendment = nullptr)
        : scene_(scene), view_(view), amendment_(std::move(amendment)) {}

    /// `answer` is a triangle of the scene, or none. `bounds` must outlive the hearing.
    void add(const ViewBounds& bounds, PrimitiveId answer, int x, int y);

    /// Decides every answer, in the order in which they were added, on all threads.
    std::vector<Ruled> hear(Asked asked = Asked::standing);

  private:
    struct Plea {
        const ViewBounds* bounds = nullptr;
        PrimitiveId answer = PrimitiveId::none;
        int x = 0, y = 0;
        double own_eps_px = 0, reach_px = 0;
        std::size_t number = 0;
    };
    /// What one thread remembers of a hearing.
    struct Memories;
    /// One go at the pleas that are left.
    class Session;

    void sort_by_tile();

    const Scene& scene_;
    const View& view_;
    Amendment amendment_;
    std::vector<Plea> pleas_;
};

}  // namespace zproof
