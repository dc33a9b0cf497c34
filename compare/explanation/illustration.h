/// The triangles around a pixel as geometry, for a drawing beside its explanation. Nothing is decided from
/// it.
#pragma once

#include <span>
#include <vector>

#include "compare/explanation/explain.h"
#include "math/affine.h"

namespace zproof {

/// A triangle's image around a pixel's centre, in double; (x, y) are offsets from the centre, px, y down.
struct NearbyImage {
    PrimitiveId primitive = PrimitiveId::none;
    std::array<Affine<double>, 3> edge;  ///< signed distance from each edge, px, positive inside
    Affine<double> inverse_depth;        ///< larger is nearer: compare/bounds/triangle_image.h
};

/// An explanation, and what is drawn beside it.
struct IllustratedExplanation {
    PixelExplanation explanation;
    std::vector<NearbyImage> images;  ///< nearest at the centre first; none that is seen edge-on
};

/// What is explained and drawn.
struct IllustrationRequest {
    std::span<const PixelCoord> places;
    double reach_px = 0;   ///< triangles whose image may come so near a place's centre are drawn
    std::size_t most = 0;  ///< at each place
};

/// As explain(), each with its drawing. One pass over the scene serves all places.
std::vector<IllustratedExplanation> illustrate(const Scene& scene, const View& view,
                                               const RenderedFrame& candidate, const RenderedFrame& reference,
                                               const IllustrationRequest& places);

}  // namespace zproof
