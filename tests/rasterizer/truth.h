/// The truth at a pixel by brute force: every triangle against the view ray, in long double, from the
/// camera's facts alone (scenes/camera.h). Shares no code with the renderer.
#pragma once

#include <optional>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

struct Truth {
    PrimitiveId primitive = PrimitiveId::none;
    double depth = 0;           ///< camera depth where primitive is not none
    double depth_slope_px = 0;  ///< |d depth / dx| + |d depth / dy|
};

/// What is seen through the centre of pixel (x, y); nothing where the answer could change within `reach_px`
/// of the centre in x and in y, or by a relative change of depth of 2^-21 (twice two float32 roundings, of
/// either surface).
std::optional<Truth> certain_truth(const Scene& scene, const View& view, int x, int y, double reach_px);

}  // namespace zproof::rasterizer
