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

/// The triangles, for each place, whose image may come within reach_px of its centre, nearest at the centre
/// first, at most `most` of them; none that is seen edge-on. One pass over the scene serves all places.
std::vector<std::vector<NearbyImage>> images_around(const Scene& scene, const View& view,
                                                    std::span<const PixelCoord> places, double reach_px,
                                                    std::size_t most);

/// An explanation, and what is drawn beside it.
struct IllustratedExplanation {
    PixelExplanation explanation;
    std::vector<NearbyImage> images;
};

/// What is explained and drawn; see images_around().
struct IllustrationRequest {
    std::span<const PixelCoord> places;
    double reach_px = 0;
    std::size_t most = 0;
};

/// explain() and images_around() together: the scene is searched once for both.
std::vector<IllustratedExplanation> illustrate(const Scene& scene, const View& view,
                                               const RenderedFrame& candidate, const RenderedFrame& reference,
                                               const IllustrationRequest& places);

}  // namespace zproof
