#include <algorithm>
#include <cmath>

#include "filters/methods/bilinear_rule.h"
#include "filters/methods/families.h"

namespace zproof::texture {

namespace {

/// OpenImageIO measures in texture coordinates, where the image is the unit square.
Footprint in_unit_square(const Footprint& f, const glm::dvec2& size) {
    return {.centre = f.centre / size, .per_x = f.per_x / size, .per_y = f.per_y / size};
}

glm::dvec2 size_of(const LinearImage& image) { return {image.width, image.height}; }

/// Two levels, and the second one's share.
struct Blend {
    int finer = 0, coarser = 0;
    double share = 0;
};

/// A width is a fraction of the unit square; on a level it counts min(width, height) texels.
double texels(const LinearImage& level, double width) { return width * std::min(level.width, level.height); }

/// The first level on which the width is at most one texel is the coarser one; its share is 2 width - 1
/// there, within [0, 1].
Blend blend(const MipReads& mips, double width) {
    for (int level = 0; level <= mips.coarsest(); ++level) {
        const double there = texels(mips.levels[std::size_t(level)], width);
        if (there <= 1)
            return level == 0 ? Blend{} : Blend{level - 1, level, std::clamp(2 * there - 1, 0.0, 1.0)};
    }
    return {mips.coarsest(), mips.coarsest(), 0};
}

/// The user's bias and clamp act on the width as they would on its log2 in texels of level 0.
double adjusted(const MipReads& mips, double width) {
    const double one = texels(mips.levels[0], 1), lod = std::log2(width * one) + mips.options.lod_bias;
    return std::exp2(std::min(std::max(lod, mips.options.lod_min), mips.options.lod_max)) / one;
}

/// A bilinear read at a place in texels of level 0.
struct Probe {
    glm::dvec2 place;
    double weight;
};

void read_both(const MipReads& mips, const Blend& levels, const Probe& at, auto&& read) {
    if (levels.share < 1) mips.bilinear(levels.finer, at.place, at.weight * (1 - levels.share), read);
    if (levels.share > 0) mips.bilinear(levels.coarser, at.place, at.weight * levels.share, read);
}

struct OwnTrilinear {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const Footprint f = in_unit_square(footprint, size_of(mips.levels[0]));
        read_both(mips, blend(mips, adjusted(mips, std::exp2(lod_chebyshev(f)))), {footprint.centre, 1},
                  read);
    }
};

/// Probes along the longer axis, from -reach to reach.
struct ProbeLine {
    glm::dvec2 reach;  ///< (major - minor) along the axis, texels
    int probes = 1;
    double exponent = 0;  ///< a probe at p of the reach, -1 < p < 1, weighs exp(-2 (exponent p)^2)
    Blend levels;
};

/// The ratio of the axes, 1 to most; where they are no numbers, 1.
double aspect_of(double major, double minor, double most) {
    return major > minor ? std::min(major / minor, most) : 1;
}

ProbeLine probe_line(const MipReads& mips, const Footprint& footprint) {
    const glm::dvec2 size = size_of(mips.levels[0]);
    const Ellipse axes = ellipse(in_unit_square(footprint, size));
    const double most = mips.options.max_anisotropy, largest = std::max(size.x, size.y);
    double major = axes.major, minor = axes.minor, aspect = aspect_of(major, minor, most);
    if (!std::isfinite(major + minor)) return {.reach = {}, .levels = {mips.coarsest(), mips.coarsest(), 0}};
    if (major > minor * most) {
        major = (major + minor * most) / 2;
        minor = major / most;
    }
    const Blend levels = blend(mips, adjusted(mips, minor));
    if (levels.coarser == 0 && minor * largest < 0.5) aspect = std::clamp(2 * major * largest, 1.0, most);
    return {(major - minor) * axes.major_direction * size, std::max(1, int(2 * aspect - 1)),
            major / (2 * (major - minor)), levels};
}

struct OwnAnisotropic {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const ProbeLine line = probe_line(mips, footprint);
        if (line.probes == 1) return read_both(mips, line.levels, {footprint.centre, 1}, read);
        const auto place = [&](int i) { return (2 * i + 1.0) / line.probes - 1; };
        const auto weight = [&](int i) {
            const double x = place(i) * line.exponent;
            return std::exp(-2 * x * x);
        };
        double sum = 0;
        for (int i = 0; i < line.probes; ++i) sum += weight(i);
        for (int i = 0; i < line.probes; ++i)
            read_both(mips, line.levels, {footprint.centre + place(i) * line.reach, weight(i) / sum}, read);
    }
};

constexpr const char* level_rule =
    "The width on a level is that fraction times min(width, height) of the level. The first level where it "
    "is at "
    "most 1 is blended with the finer one before it.";

}  // namespace

std::vector<Method> openimageio_methods() {
    return {
        {.name = "trilinear-oiio",
         .card = {.footprint = "The largest absolute entry of the Jacobian, as a fraction of the texture's "
                               "width (s) or height (t): the conservative filter.",
                  .lod = level_rule,
                  .taps = "Bilinear in both; the coarser level's share is 2 width - 1 there, within [0, 1]: "
                          "linear in the width, not in its logarithm.",
                  .source = "OpenImageIO, texture_lookup_trilinear_mipmap and compute_miplevels; bias and "
                            "clamp act on log2 of the width"},
         .prepare = prepare_bilinear<OwnTrilinear>},
        {.name = "aniso-oiio",
         .card =
             {.footprint =
                  "The ellipse of the Jacobian's singular values in texture coordinates (width and height "
                  "1), s1 >= s2. Aspect s1 / s2, at most a, the maximum anisotropy; where it exceeds a, s1 "
                  "becomes (s1 + a s2) / 2 and s2 s1 / a: the conservative filter.",
              .lod = std::string{"The width is s2. "} + level_rule +
                     " On level 0 alone, with s2 max(width, height) < 1/2, the aspect is 2 s1 max(width, "
                     "height), 1 to a.",
              .taps =
                  "n = max(1, floor(2 aspect - 1)) bilinear probes in either level, at p = (2 i + 1) / n - "
                  "1, i = 0 to n - 1, times (s1 - s2) along the longer axis, linear about the centre. Each "
                  "weighs exp(-2 x^2), x = p s1 / (2 (s1 - s2)), divided by the sum. The coarser level's "
                  "share is 2 width - 1 there, within [0, 1]. A footprint that is not finite is one probe of "
                  "the "
                  "last level.",
              .source =
                  "OpenImageIO, texture_lookup and compute_ellipse_sampling, bilinear instead of its "
                  "smart bicubic, without its limits against degenerate derivatives; bias and clamp act "
                  "on log2 of the width"},
         .prepare = prepare_bilinear<OwnAnisotropic>}};
}

}  // namespace zproof::texture
