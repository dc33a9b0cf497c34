#include "study/shading/reflection.h"

#include <algorithm>
#include <cmath>

namespace zproof::study::shading {

double intensity(const Spot& spot, const Lamp& lamp, const Finish& finish) {
    const glm::dvec3 light = lamp.toward(spot.p_world);
    const double facing = glm::dot(spot.normal, light);
    if (!(facing > 0)) return finish.ambient;
    const glm::dvec3 mirrored = 2 * facing * spot.normal - light;
    const double cosine = finish.highlight == Highlight::phong
                              ? glm::dot(mirrored, spot.toward_eye)
                              : glm::dot(spot.normal, glm::normalize(light + spot.toward_eye));
    return finish.ambient + finish.diffuse * facing +
           finish.specular * std::pow(std::max(0.0, cosine), finish.exponent);
}

}  // namespace zproof::study::shading
