/// Answers heard together: each is decided by the admissible set, in the surroundings that the scene gives
/// it.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <functional>
#include <optional>
#include <span>

#include "compare/hearing/ruled.h"
#include "math/bulk.h"
#include "scenes/scene.h"

namespace zproof {

/// Changes what stands around an answer before it is decided: another rule of drawing than the law.
using Amendment = std::function<void(Neighbourhood& around, PrimitiveId answer)>;

/// An answer to be heard: a triangle of the scene, or none, at a pixel.
struct Plea {
    const ViewBounds* bounds = nullptr;  ///< the renderer's; without, nothing is asked
    PrimitiveId answer = PrimitiveId::none;
    int x = 0, y = 0;
};

/// A hearing takes a pass over the scene whatever the number of pleas: put many into one.
class Hearing {
  public:
    Hearing(const Scene& scene, const View& view, Amendment amendment = nullptr)
        : scene_(scene), view_(view), amendment_(std::move(amendment)) {}

    /// Decides every plea, on all threads; the rulings are in the pleas' order. Where nothing is asked they
    /// are empty.
    Bulk<Ruled> hear(Bulk<Plea> pleas, Asked asked = Asked::standing);

  private:
    /// The pleas of a tile: places from first to before end.
    struct Sitting {
        std::size_t tile;
        std::uint32_t first, end;
    };
    /// The pleas that are left, tile by tile, each in their order.
    struct Docket {
        Bulk<std::uint32_t> plea;       ///< a place among pleas_
        Bulk<double> reach_px;          ///< 0 where it is not known yet
        std::vector<Sitting> sittings;  ///< by tile; none without a plea
    };
    /// What one thread remembers of a hearing.
    struct Memories;
    using ThreadMemories = tbb::enumerable_thread_specific<Memories>;
    /// One go at the pleas that are left.
    class Session;

    /// Pleas of one tile that follow each other: from first to before end, but for what asks nothing.
    struct Run {
        std::size_t tile;
        std::uint32_t first, end = 0, pleas = 0;
        std::uint32_t place = 0;  ///< of the docket
    };
    std::vector<Run> runs_of_tiles() const;
    Docket docket_of_all() const;
    bool may_glance(Asked asked) const;
    /// The farthest first reach of some pleas.
    double likely_reach_px(const Docket& docket, Memories& memories) const;
    void set_reach(Docket& docket, const Sitting& sitting, Memories& memories) const;
    Docket left_over(const Docket& docket, const Bulk<double>& lacking) const;

    const Scene& scene_;
    const View& view_;
    Amendment amendment_;
    Bulk<Plea> pleas_;
};

}  // namespace zproof
