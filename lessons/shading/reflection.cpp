#include "lessons/shading/reflection.h"

#include <algorithm>
#include <cmath>

namespace zproof::study::shading {

double intensity(const SurfacePoint& surface_point, const LightSource& light_source, const Finish& finish) {
    const glm::dvec3 light = light_source.toward(surface_point.p_world);
    const double facing = glm::dot(surface_point.normal, light);
    if (!(facing > 0)) return finish.ambient;
    const glm::dvec3 mirrored = 2 * facing * surface_point.normal - light;
    const double cosine =
        finish.highlight == Highlight::phong
            ? glm::dot(mirrored, surface_point.toward_eye)
            : glm::dot(surface_point.normal, glm::normalize(light + surface_point.toward_eye));
    return finish.ambient + finish.diffuse * facing +
           finish.specular * std::pow(std::max(0.0, cosine), finish.exponent);
}

}  // namespace zproof::study::shading
