/// The shading study on a scene: each method where the rasterizer draws it, against the same method at
/// Embree's hits, and against Phong's.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "lessons/shading/tessellation.h"

namespace zproof::study::shading {

/// A technique on a view, over the pixels at which rasterizer and Embree see the same triangle.
struct SceneScore {
    Method method = Method::phong;
    Mixing mixing = Mixing::perspective;
    Highlight highlight = Highlight::phong;
    LightSource::Kind light_source = LightSource::Kind::directional;
    /// The error against the same method, perspective-correct, at Embree's hits: what rasterizing and mixing
    /// cost.
    double rmse_to_traced = 0, largest_to_traced = 0;
    /// The most that affine mixing may cost Gouraud's method (docs/shading.md); NaN for all else.
    double predicted_largest = std::numeric_limits<double>::quiet_NaN();
    /// The error against Phong's method at Embree's hits: what the method costs.
    double rmse_to_phong = 0, largest_to_phong = 0;
};

/// Phong's method against POV-Ray's smooth triangles: directional light, Phong's highlight, white surfaces.
struct PovrayScore {
    std::string not_asked;   ///< why; empty where it was
    std::size_t pixels = 0;  ///< compared
    /// Left out: pixels at a silhouette whose mixed normal points away from the eye, which POV-Ray turns
    /// over.
    std::size_t turned = 0;
    double rmse = 0, p99 = 0, largest = 0;
};

struct ScenePicture {
    std::string name;
    Plane<double> intensity, difference;  ///< difference: from Phong at Embree's hits, absolute
};

struct ShadingStudy {
    std::string scene, view;
    std::size_t pixels = 0;     ///< compared
    std::size_t other_ids = 0;  ///< left out: edges, mostly
    std::vector<SceneScore> scores;
    PovrayScore povray;
    std::vector<ScenePicture> pictures;  ///< of the directional light and Phong's highlight
};

using Announce = std::function<void(const std::string& what)>;

/// The scene with normals at its vertices: its own where it has any, else the sum of the normals of the
/// triangles around each vertex, weighted by their areas, as the lecture's first step has it.
Scene with_normals(const Scene& scene);

/// Studies with_normals(scene). The directional light comes over the viewer's shoulder, the point light hangs
/// above and to the right of the eye by half the median depth. POV-Ray not being there, or refusing, is a
/// value. Embree's refusal throws OracleError.
ShadingStudy study_shading(const Scene& scene, const View& view, const Announce& announce);
int units_of_shading();

/// The light of scenes/light.h, in this view's world.
Lighting lighting_of(const View& view, Highlight highlight);

}  // namespace zproof::study::shading
