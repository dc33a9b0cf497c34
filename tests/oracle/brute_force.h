/// Every ray against every triangle in long double, with the errors that Embree's float32 may make beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"
#include "tests/oracle/scenes_at_random.h"

namespace zproof::oracle {

/// The one answer that float32 must give at a pixel.
struct CertainAnswer {
    PrimitiveId primitive = PrimitiveId::none;
    long double depth = background_depth;
    long double depth_error = 0;  ///< float32's depth differs by at most this
};

/// None where rounding decides: an edge, a clip plane or another surface is closer than float32 can tell.
std::optional<CertainAnswer> certain_answer(const Scene& scene, const View& view, int x, int y);

/// An oracle under test: what it sees, how many scenes it is shown, and whether its depths are better than
/// float32's own arithmetic.
struct Caster {
    std::function<Frame(const Scene&, const View&)> cast;
    std::uint32_t scenes;
    std::function<double(const View&, double depth)> depth_error;  ///< where empty, float32's own
};

/// Where float32 cannot be mistaken, the caster is not.
void expect_agreement(const Caster& caster, ProjectionKind projection_kind);

}  // namespace zproof::oracle
