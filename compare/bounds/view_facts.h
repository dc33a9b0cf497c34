/// What the bounds of every renderer take from a view.
#pragma once

#include "compare/bounds/triangle_extent.h"
#include "scenes/view.h"

namespace zproof {

/// What a displaced point moves in the image.
struct ImageScale {
    double px_per_u, px_per_v;  ///< pixels per unit of the image plane
    double slant_u, slant_v;    ///< largest |d(u, v)/d depth| of a view ray in the image

    /// Largest displacement in the image, px times depth, of errors of camera_abs along the camera's axes.
    double lateral_px(const glm::dvec3& camera_abs) const {
        return std::max(px_per_u * (camera_abs.x + slant_u * camera_abs.z),
                        px_per_v * (camera_abs.y + slant_v * camera_abs.z));
    }
};

/// A share of far - near; nothing is known without a finite far.
inline double depth_of_range(const Camera& c, double share) {
    return share > 0 ? share * (c.far_depth - c.near_depth) : 0;
}

struct ViewFacts {
    explicit ViewFacts(const View& view);

    TriangleExtent extent_of(const CornersWorld& p_world) const;
    /// The error of a functional moment . direction as a distance in the image, px.
    double distance_px(double error, const glm::dvec3& moment) const;
    /// What all rays of a parallel projection advance by, for one unit of depth.
    glm::dvec3 direction() const {
        const Camera& c = view.camera;
        return c.shear.x * c.right + c.shear.y * c.up - c.back;
    }
    /// A corner's place in the image plane, in units of the window: for perspective before the divide.
    glm::dvec2 before_divide(const TriangleExtent& extent, std::size_t corner) const;

    View view;
    bool perspective;
    ImageScale scale;
    double largest_u, largest_v;         ///< of |window|
    glm::dvec3 right_per_px, up_per_px;  ///< of a point at depth 1
    glm::dvec3 direction_abs;            ///< per world axis, the largest |direction| in the image
    double start;           ///< parallel: how far behind the eye rays start, on the near plane; else 0
    glm::dvec3 origin_abs;  ///< per world axis, the largest |origin - eye|
    double orthonormality;  ///< largest entry of |R R^T - I|

  private:
    PlaneSize plane_size(const glm::dvec3& v0, const CornersWorld& p_world) const;
};

}  // namespace zproof
