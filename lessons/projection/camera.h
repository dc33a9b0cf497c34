/// A view's camera as numbers of one type: what a program that computes in that type has at hand.
#pragma once

#include "lessons/projection/spaces.h"
#include "math/rational.h"
#include "scenes/view.h"

namespace zproof::study::projection {

/// The canvas: the part of the image plane that fills the image.
template <class Number>
struct Canvas {
    Number left, right, bottom, top;
};

template <class Number>
struct NumericCamera {
    Projection projection = Projection::perspective;
    Vector3<Number> eye;  ///< world space
    /// Rows of the matrix that takes p_world - eye to camera space. For machine numbers these are the
    /// camera's axes, rounded, as renderers have them; for Rational they are the inverse of the matrix of the
    /// axes, which are orthonormal to a few ulps only. So Rational gives the one true place.
    std::array<Vector3<Number>, 3> to_camera;
    Canvas<Number> canvas;   ///< at camera depth 1 for perspective, through the eye for parallel
    Canvas<Number> on_near;  ///< the canvas where the lessons have it: on the near plane; parallel: the same
    Point2<Number> shear;    ///< sideways step per unit of depth; 0 for perspective
    Number near, far;        ///< camera depths; far is 0 where it is infinite
    bool has_far = true;
    Number width, height;  ///< pixels
};

/// Every number of the camera rounded once; products of them (on_near) once more.
template <class Number>
NumericCamera<Number> camera_of(const View& view);

template <>
NumericCamera<Rational> camera_of<Rational>(const View& view);

extern template NumericCamera<float> camera_of<float>(const View& view);
extern template NumericCamera<double> camera_of<double>(const View& view);

}  // namespace zproof::study::projection
