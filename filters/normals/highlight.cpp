#include "filters/normals/highlight.h"

#include <algorithm>
#include <cmath>

namespace zproof::normals {

double blinn_phong(const glm::dvec3& normal, const glm::dvec3& h, double s) {
    return std::pow(std::max(glm::dot(normal, h), 0.0), s);
}

double of_mean_normal(const glm::dvec3& mean, const glm::dvec3& h, double s) {
    const double length = glm::length(mean);
    return length > 0 ? blinn_phong(mean / length, h, s) : 0;
}

double toksvig(const glm::dvec3& mean, const glm::dvec3& h, double s) {
    const double length = std::min(glm::length(mean), 1.0);
    const double f = length / (length + s * (1 - length));
    return (1 + f * s) / (1 + s) * of_mean_normal(mean, h, f * s);
}

double lean(const SlopeMoments& moments, const glm::dvec3& h, double s) {
    const glm::dvec2 m = moments.mean, d = glm::dvec2{h.x / h.z, h.y / h.z} - m;
    // Rounded moments may have a variance a little below 0.
    const double xx = std::max(moments.xx - m.x * m.x, 0.0) + 1 / s,
                 yy = std::max(moments.yy - m.y * m.y, 0.0) + 1 / s, xy = moments.xy - m.x * m.y;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0)) return 0;
    const double distance2 = (d.x * d.x * yy - 2 * d.x * d.y * xy + d.y * d.y * xx) / determinant;
    return std::exp(-distance2 / 2) / (s * std::sqrt(determinant));
}

}  // namespace zproof::normals
