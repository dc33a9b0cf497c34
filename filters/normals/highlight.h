/// Highlights of one normal, and of many that are known by their means.
///
/// h is the unit vector halfway between light and eye, s > 0 the exponent of Blinn and Phong.
#pragma once

#include <glm/glm.hpp>

namespace zproof::normals {

/// (n . h)^s; nothing where h lies behind. Blinn 1977.
double blinn_phong(const glm::dvec3& normal, const glm::dvec3& h, double s);

/// That of the mean normal made a unit again: what a filtered normal map shows without more.
double of_mean_normal(const glm::dvec3& mean, const glm::dvec3& h, double s);

/// The mean normal's length says how far normals are apart: with f = |N| / (|N| + s (1 - |N|)), the highlight
/// of exponent f s times (1 + f s) / (1 + s). Toksvig 2005, Mipmapping Normal Maps.
double toksvig(const glm::dvec3& mean, const glm::dvec3& h, double s);

/// Means of slopes B, and of their products.
struct SlopeMoments {
    glm::dvec2 mean{0};
    double xx = 0, yy = 0, xy = 0;
};

/// A Gaussian of slopes: with C the slopes' covariance plus 1 / s, exp(-d C^-1 d / 2) / (s sqrt |C|), d: h's
/// slope less the mean. Olano and Baker 2010, LEAN Mapping. Without bumps it is exp(-s tan^2 / 2), near to
/// Blinn and Phong's.
double lean(const SlopeMoments& moments, const glm::dvec3& h, double s);

}  // namespace zproof::normals
