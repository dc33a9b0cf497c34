/// The scenes of the reports, from their numbers.
#pragma once

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::field_reports {

/// One triangle.
Scene one_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
/// An upright square of two triangles at z = -depth.
Scene square_ahead(float depth, float half_side);
/// Ground, a ball, two boxes and a post, each a part with a node of its own; two materials. Triangles 2k and
/// 2k + 1 make a quad.
Scene yard();
/// A hilly ground of n x n squares; every vertex once.
Scene hills(int n);

/// A camera at the origin that looks along -z.
View view_ahead(double yfov_degrees, int width, int height, double near_depth, double far_depth);
/// The same, orthographic.
View parallel_view_ahead(double half_width, double half_height, int width, int height, double near_depth,
                         double far_depth);
/// A view of the yard with background in it.
View view_of_yard(int width = 96, int height = 72);
View parallel_view_of_yard(double half_width, double half_height, int width, int height);

}  // namespace zproof::field_reports
