/// Which triangle is seen at a raster position, and how deep a triangle's plane lies there: in plain double,
/// for frames that are to look right. Nobody is judged by it.
#pragma once

#include <vector>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::frozen {

/// Camera depth of the triangle's plane in the view ray through a raster position; 1 where the plane is
/// seen edge-on or lies behind the eye.
float depth_at(const Scene& scene, const View& view, PrimitiveId triangle, const glm::dvec2& p_raster);

/// At every pixel that shows a triangle: depth_at its centre.
void set_true_depths(const Scene& scene, const View& view, Frame& frame);

/// The nearest triangle between near and far that covers the raster position; none where there is none.
PrimitiveId seen_at(const Scene& scene, const View& view, const glm::dvec2& p_raster);

/// Every triangle that covers it in front of the eye.
std::vector<PrimitiveId> all_at(const Scene& scene, const View& view, const glm::dvec2& p_raster);

}  // namespace zproof::frozen
