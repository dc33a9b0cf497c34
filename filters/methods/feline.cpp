#include <algorithm>
#include <cmath>

#include "filters/methods/bilinear_rule.h"
#include "filters/methods/families.h"

namespace zproof::texture {

namespace {

/// The Gaussian's steepness, as for elliptical weighted averages.
constexpr double alpha = 2;

struct Probes {
    int count = 1;
    glm::dvec2 step{0};  ///< texels from probe to probe
    double major = 1;    ///< texels
    double lod = 0;

    glm::dvec2 offset(int i) const { return (i - (count - 1) / 2.0) * step; }
    double weight(int i) const {
        const double d = glm::length(offset(i)) / major;
        return std::exp(-alpha * d * d);
    }
};

Probes probes(const Footprint& f, int max_anisotropy) {
    const Ellipse axes = ellipse(f);
    const double major = std::max(axes.major, 1.0), most = 2.0 * max_anisotropy - 1;
    double minor = std::max(axes.minor, 1.0);
    const double wanted = 2 * (major / minor) - 1;
    if (!std::isfinite(wanted)) return {.lod = std::log2(major)};
    const int count = int(std::min(std::floor(wanted + 0.5), most));
    if (count < wanted) minor = 2 * major / (count + 1);
    const glm::dvec2 whole = 2 * (major - minor) * axes.major_direction;
    return {count, count > 1 ? whole / double(count - 1) : glm::dvec2{0}, major, std::log2(minor)};
}

struct Feline {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const Probes line = probes(footprint, mips.options.max_anisotropy);
        const double lod = mips.in_chain(line.lod);
        double sum = 0;
        for (int i = 0; i < line.count; ++i) sum += line.weight(i);
        for (int i = 0; i < line.count; ++i)
            mips.trilinear(lod, footprint.centre + line.offset(i), line.weight(i) / sum, read);
    }
};

}  // namespace

std::vector<Method> feline_methods() {
    return {
        {.name = "aniso-feline",
         .card =
             {.footprint =
                  "The ellipse of the Jacobian's singular values, both raised to at least 1 texel: radii R "
                  ">= r. "
                  "N = 2 R / r - 1 rounded half up, at most 2 a - 1, a: maximum anisotropy; where N is less "
                  "than 2 R / r - 1, r = 2 R / (N + 1).",
              .lod = "log2 r.",
              .taps =
                  "N trilinear probes, evenly from -(R - r) to R - r along the longer axis, linear about "
                  "the centre; one at distance d weighs exp(-2 (d / R)^2), divided by the sum. A footprint "
                  "that is not finite is one probe.",
              .source = "McCormack, Perry, Farkas and Jouppi 1999 (Feline); steepness 2 and the limit by "
                        "anisotropy are ours"},
         .prepare = prepare_bilinear<Feline>}};
}

}  // namespace zproof::texture
