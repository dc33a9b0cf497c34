/// A lit, textured picture of a scene as POV-Ray reads it: one mesh2 in float32, which is enough for colours.
#pragma once

#include <string>
#include <vector>

#include "scenes/light.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// specular max(0, r . v)^exponent of white on top of what scenes/light.h says: r is the light's direction
/// mirrored at the normal, v points to the eye (POV-Ray's finish `phong`, documentation 3.7, 3.4.6.3.4.1).
struct PhongFinish {
    double specular = 0, exponent = 40;
};

struct PovrayImage {
    std::string name;   ///< of the file that the text refers to
    std::string bytes;  ///< PNG
};

struct PovrayPicture {
    std::string text;
    std::vector<PovrayImage> images;
};

/// Surfaces as scenes/light.h and rasterizer/shader.h have them. Throws OracleError for what POV-Ray cannot
/// say: a texture times vertex colours, more than 65536 different colours, or as povray_texture.
PovrayPicture povray_picture(const Scene& scene, const View& view, const Light& light,
                             const PhongFinish& phong_finish = {});

}  // namespace zproof::oracle
