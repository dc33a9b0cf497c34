/// What the bounds of a triangle are made of (docs/bounds.md). Written without branches, so that the compiler
/// works on several pixels at a time.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>
#include <limits>

namespace zproof {

/// A bound where nothing is known.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

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

/// 1 / (1 - sum) - 1: what factors and divisors whose relative errors add up to `sum` may come to (Higham
/// 2002, Lemma 3.1); unlimited from 1 up.
inline double compounded(double sum) {
    const double share = sum / (1 - sum);
    return sum < 1 ? share : unlimited;
}

/// `a` held between two limits.
inline double held_between(double a, double low, double high) {
    const double raised = a < low ? low : a;
    return high < raised ? high : raised;
}

/// eps = base + per (inverse depth + gradient eps), solved for eps; never beyond the nearest corner's.
struct Displacement {
    Displacement() = default;
    Displacement(double base_px, double per_inverse_depth, double gradient, double highest)
        : base(base_px), per(per_inverse_depth), most(base + per * highest) {
        const double loop = per * gradient, enlarged = 1 / (1 - loop);
        amplification = loop < 1 ? enlarged : unlimited;
    }

    double at(double inverse_depth) const {
        const double reach = (base + per * inverse_depth) * amplification, kept = reach < most ? reach : most;
        return per == 0 ? base : kept;
    }

    double base = 0, per = 0, most = 0, amplification = 1;
};

/// The inverse depth of the farthest and the nearest corner.
struct CornerInverseDepth {
    CornerInverseDepth() = default;
    CornerInverseDepth(double nearest_depth, double farthest_depth) {
        const double of_farthest = 1 / farthest_depth, of_nearest = 1 / nearest_depth;
        least = farthest_depth > 0 ? of_farthest : 0;  // 0 at infinity, too
        highest = nearest_depth > 0 ? of_nearest : 0;
    }

    double least = 0, highest = 0;
};

}  // namespace zproof
