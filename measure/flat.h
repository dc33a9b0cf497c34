/// Triangles that face the camera at one depth, for both projections.
#pragma once

#include "measure/probe.h"
#include "measure/renderer.h"

namespace zproof::measure {

/// 2 px wide and two rows high for each lane, around the origin, the eye on the z axis at eye_depth: the
/// plane z = t has camera depth eye_depth - t, and near t = 0 float32 coordinates are finer than any depth
/// buffer.
View flat_view(Projection projection, double eye_depth, const Bracket& near_and_far);

/// Near and far of the views that look for steps of depth, and for the planes themselves.
inline constexpr Bracket depth_range_of_steps{1, 512}, depth_range_of_limits{0.75, 96};

enum class Half { left, right };

inline constexpr int lane_count = 64;
constexpr int row_of(int lane) { return 2 * lane; }

/// Covers the sample in one column of the lane's row, wherever in its pixel that is, and those of no other
/// lane.
void add_flat(Scene& scene, const View& view, int lane, Half half, float z);

inline constexpr std::array both_projections{Projection::parallel, Projection::perspective};

}  // namespace zproof::measure
