/// Depths of somebody's own kind as camera depth, worked out in double from the view's exact camera.
#pragma once

#include "frame/convention.h"
#include "scenes/view.h"

namespace zproof {

/// docs/conventions.md states each formula and how far its result may be off.
class CameraDepth {
  public:
    /// Throws FrameError where the kind means nothing in this view: a disparity of a parallel projection.
    CameraDepth(const Convention& convention, const View& view);

    /// The camera depth of a stored depth at the centre of pixel (x, y). What is no depth stays none: NaN
    /// stays NaN, and a value beyond its range becomes negative, infinite or a depth beyond near or far.
    double operator()(double stored, int x, int y) const;
    bool is_identity() const;  ///< Is every stored depth its own camera depth?

    /// Does a stored value say "background"?
    bool is_background(double stored) const;

  private:
    /// Camera depth per unit of ray length.
    double per_length(int x, int y) const;
    /// `q` falls from 1 at near to 0 at far, affine in z.
    double of_remaining_z(double q) const;
    /// What a surface on the far plane has, before the scale.
    double far_value() const;

    Convention convention_;
    View view_;
};

}  // namespace zproof
