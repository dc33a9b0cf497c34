/// A triangle's weights in the image, as they are held against a tolerance.
#pragma once

#include "compare/admissible/neighbourhood.h"

namespace zproof {

/// Edge functions in proportion to the weights that are held against a tolerance.
template <class Number>
std::array<Affine<Number>, 3> weights_of(const ViewRay<Number>& ray, const Neighbour& n) {
    const Corners<Number> corners = zproof::corners<Number>(n.p_world);
    std::array<Affine<Number>, 3> weights = edges_of(ray, corners);
    if (n.has_image_weights)
        for (std::size_t i = 0; i < 3; ++i)
            weights[i] = camera_depth<Number>(ray, corners[i] - ray.origin) * weights[i];
    return weights;
}

}  // namespace zproof
