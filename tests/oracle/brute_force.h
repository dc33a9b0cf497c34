/// Every ray against every triangle in long double, with the errors that Embree's float32 may make beside it.
#pragma once

#include <optional>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// The one answer that float32 must give at a pixel.
struct CertainAnswer {
    PrimitiveId primitive = PrimitiveId::none;
    long double depth = background_depth;
    long double depth_error = 0;  ///< float32's depth differs by at most this
};

/// None where rounding decides: an edge, a clip plane or another surface is closer than float32 can tell.
std::optional<CertainAnswer> certain_answer(const Scene& scene, const View& view, int x, int y);

}  // namespace zproof::oracle
