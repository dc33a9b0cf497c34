/// Answers heard together: each is decided by the admissible set, in the surroundings that the scene gives
/// it.
#pragma once

#include <tbb/enumerable_thread_specific.h>

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

    /// That many answers will be added.
    void expect(std::size_t count) { pleas_.reserve(count); }
    /// `answer` is a triangle of the scene, or none. `bounds` must outlive the hearing.
    void add(const ViewBounds& bounds, PrimitiveId answer, int x, int y) {
        pleas_.push_back({&bounds, answer, x, y, added_++});
    }
    /// Nothing is asked; what is ruled there is empty.
    void add_none() { ++added_; }

    /// Decides every answer, in the order in which they were added, on all threads.
    std::vector<Ruled> hear(Asked asked = Asked::standing);

  private:
    struct Plea {
        const ViewBounds* bounds = nullptr;
        PrimitiveId answer = PrimitiveId::none;
        int x = 0, y = 0;
        std::uint32_t number = 0;
    };
    /// The pleas of a tile: places from first to before end.
    struct Sitting {
        std::size_t tile;
        std::uint32_t first, end;
    };
    /// The pleas that are left, tile by tile, each in the order in which they were added.
    struct Docket {
        std::vector<std::uint32_t> plea;  ///< a place among pleas_
        std::vector<double> reach_px;     ///< 0 where it is not known yet
        std::vector<Sitting> sittings;    ///< by tile; none without a plea
    };
    /// What one thread remembers of a hearing.
    struct Memories;
    using ThreadMemories = tbb::enumerable_thread_specific<Memories>;
    /// One go at the pleas that are left.
    class Session;

    Docket docket_of_all() const;
    /// Is it worth it to ask every plea for its reach before triangles are searched for?
    bool may_reach_far(const Docket& docket, Memories& memories) const;
    void set_reach(Docket& docket, const Sitting& sitting, Memories& memories) const;
    Docket left_over(const Docket& docket, const std::vector<double>& lacking) const;

    const Scene& scene_;
    const View& view_;
    Amendment amendment_;
    std::vector<Plea> pleas_;
    std::uint32_t added_ = 0;
};

}  // namespace zproof
