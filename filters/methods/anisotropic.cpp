#include <cmath>

#include "filters/methods/bilinear_rule.h"
#include "filters/methods/families.h"

namespace zproof::texture {

namespace {

/// Equal trilinear taps on a line through the footprint's centre.
struct Line {
    glm::dvec2 whole{0};  ///< texels, from one end to the other
    int taps = 1;
    double width = 0;           ///< texels that each tap covers: its LOD is the log2
    glm::dvec2 whole_raster{};  ///< the same line on the picture, pixels; of the pixel's steps alone
};

constexpr reads::TapSpacing literal_places{.first = 1, .more = 1}, midpoints{.first = 0.5, .more = 0};

/// What is no number is the most that is allowed.
double limited(double ratio, double most) { return std::isfinite(ratio) ? std::min(ratio, most) : most; }

int whole_taps(double ratio, double most) { return std::max(1, int(std::ceil(limited(ratio, most)))); }

enum class RatioInLod { rounded_up, as_it_is };

template <RatioInLod ratio_in_lod>
Line longer_of(const glm::dvec2& per_x, const glm::dvec2& per_y, int max_anisotropy) {
    const double x = glm::length(per_x), y = glm::length(per_y);
    const double longer = std::max(x, y), shorter = std::min(x, y);
    const double ratio = longer > 0 ? limited(longer / shorter, max_anisotropy) : 1;
    const int taps = whole_taps(ratio, max_anisotropy);
    const double divisor = ratio_in_lod == RatioInLod::rounded_up ? taps : ratio;
    return x > y ? Line{per_x, taps, longer / divisor, {1, 0}} : Line{per_y, taps, longer / divisor, {0, 1}};
}

template <RatioInLod ratio_in_lod>
Line longer_step(const Footprint& f, int max_anisotropy) {
    return longer_of<ratio_in_lod>(f.per_x, f.per_y, max_anisotropy);
}

/// The whole axes of the cone's ellipse stand for the pixel's steps: gradients 2 g1 and 2 g2, as the erratum
/// has them.
Line cone_axis(const Footprint& f, int max_anisotropy) {
    return longer_of<RatioInLod::rounded_up>(2.0 * f.cone.along, 2.0 * f.cone.across, max_anisotropy);
}

Line ellipse_axis(const Footprint& f, int max_anisotropy) {
    const Ellipse axes = ellipse(f);
    double ratio = axes.major > 0 ? axes.major / axes.minor : 1, minor = axes.minor;
    if (!(ratio <= max_anisotropy)) {
        ratio = max_anisotropy;
        minor = axes.major / ratio;
    }
    if (minor < 1) ratio = std::max(1.0, ratio * minor);
    return {axes.major * axes.major_direction, whole_taps(ratio, max_anisotropy), minor};
}

template <Line (*line_of)(const Footprint&, int), const reads::TapSpacing& on_line>
struct LinearTaps {
    static constexpr reads::TapSpacing spacing = on_line;

    LineOfTaps line(const MipReads& mips, const Footprint& footprint) const {
        const Line line = line_of(footprint, mips.options.max_anisotropy);
        return {line.whole, line.taps, mips.in_chain(std::log2(line.width))};
    }
};

/// Each tap is seen through its own place of the picture.
template <Line (*line_of)(const Footprint&, int)>
struct ProjectiveTaps {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const Line line = line_of(footprint, mips.options.max_anisotropy);
        const double lod = mips.in_chain(std::log2(line.width));
        for (int i = 0; i < line.taps; ++i) {
            const double along = (i + literal_places.first) / (line.taps + literal_places.more) - 0.5;
            mips.trilinear(lod, footprint.at(footprint.centre_raster + along * line.whole_raster),
                           1.0 / line.taps, read);
        }
    }
};

/// The elliptical filter by anisotropic lookups: the pixel's own steps, at places along the longer axis.
struct EllipseOfLookups {
    static constexpr int spaces = 5, each_side = 2;

    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const int limit = mips.options.max_anisotropy;
        const Line lookup = ellipse_axis(footprint, limit);
        const double lod = mips.in_chain(std::log2(lookup.width));
        const glm::dvec2 step = between_lookups(footprint, limit);
        const int reach = step == glm::dvec2{0} ? 0 : each_side;
        double sum = 0;
        for (int i = -reach; i <= reach; ++i) sum += weight(i);
        for (int i = -reach; i <= reach; ++i)
            for (int tap = 0; tap < lookup.taps; ++tap) {
                const double along = (tap + midpoints.first) / (lookup.taps + midpoints.more) - 0.5;
                const glm::dvec2 place = footprint.centre + double(i) * step + along * lookup.whole;
                mips.trilinear(lod, place, weight(i) / sum / lookup.taps, read);
            }
    }

  private:
    static double weight(int i) { return std::exp(-double(std::abs(i)) / spaces); }

    /// 0 where one lookup reaches far enough, or where the ellipse is not finite.
    static glm::dvec2 between_lookups(const Footprint& f, int max_anisotropy) {
        const Ellipse axes = ellipse(f);
        const double line = 2 * (axes.major - max_anisotropy * axes.minor / 2);
        return std::isfinite(line) && line > 0 ? line / spaces * axes.major_direction : glm::dvec2{0};
    }
};

constexpr auto extension_line = longer_step<RatioInLod::rounded_up>;
constexpr auto vulkan_line = longer_step<RatioInLod::as_it_is>;

constexpr const char* extension_footprint =
    "The longer of the pixel's two steps, P_max (the one in y where they are equal), by the shorter, P_min; "
    "N = "
    "min(ceil(P_max / P_min), maximum anisotropy), 1 where P_max is 0.";
constexpr const char* extension_lod = "log2(P_max / N).";
constexpr const char* vulkan_footprint =
    "The longer of the pixel's two steps, rho_max (the one in y where they are equal), by the shorter, "
    "rho_min; eta = min(rho_max / rho_min, maximum anisotropy), 1 where rho_max is 0; N = ceil(eta).";
constexpr const char* vulkan_lod = "log2(rho_max / eta): the ratio is not rounded up.";
constexpr const char* projective_taps =
    "N trilinear taps, each seen through its own place of the picture; mean. They stand at (x - 1/2 + i / (N "
    "+ "
    "1), y), i = 1 to N, where the longer step is that in x, else at (x, y - 1/2 + i / (N + 1)).";
constexpr const char* linear_taps =
    "N trilinear taps along the longer step, linear about the centre, at i / (N + 1) - 1/2 of it, i = 1 to "
    "N; mean.";
constexpr const char* midpoint_taps =
    "N trilinear taps along the longer step, linear about the centre, at (i - 1/2) / N - 1/2 of it, i = 1 to "
    "N; mean.";

}  // namespace

std::vector<Method> anisotropic_methods() {
    return {
        {.name = "aniso-ext",
         .card = {.footprint = extension_footprint,
                  .lod = extension_lod,
                  .taps = projective_taps,
                  .source = "EXT_texture_filter_anisotropic, to the letter"},
         .prepare = prepare_bilinear<ProjectiveTaps<extension_line>>},
        {.name = "aniso-ext-linear",
         .card = {.footprint = extension_footprint,
                  .lod = extension_lod,
                  .taps = linear_taps,
                  .source =
                      "EXT_texture_filter_anisotropic, taps linear in the texture instead of the picture"},
         .prepare = prepare_bilinear<LinearTaps<extension_line, literal_places>>},
        {.name = "aniso-midpoint",
         .card = {.footprint = extension_footprint,
                  .lod = extension_lod,
                  .taps = midpoint_taps,
                  .source = "EXT_texture_filter_anisotropic, taps at the middles of N equal parts"},
         .prepare = prepare_bilinear<LinearTaps<extension_line, midpoints>>},
        {.name = "aniso-vulkan",
         .card = {.footprint = vulkan_footprint,
                  .lod = vulkan_lod,
                  .taps = projective_taps,
                  .source =
                      "Vulkan specification, Scale Factor Operation, LOD Operation and Texel Anisotropic "
                      "Filtering, to the letter; its taps are of one level, ours of two"},
         .prepare = prepare_bilinear<ProjectiveTaps<vulkan_line>>},
        {.name = "aniso-vulkan-linear",
         .card = {.footprint = vulkan_footprint,
                  .lod = vulkan_lod,
                  .taps = linear_taps,
                  .source = "Vulkan specification, taps linear in the texture instead of the picture"},
         .prepare = prepare_bilinear<LinearTaps<vulkan_line, literal_places>>},
        {.name = "aniso-d3d11",
         .card = {.footprint =
                      "The ellipse of the Jacobian's singular values s1 >= s2. Ratio s1 / s2; where that "
                      "exceeds the maximum anisotropy a, it is a and the width s1 / a, else the width "
                      "is s2. A width below 1 texel lowers the ratio to max(1, ratio width).",
                  .lod = "log2 of the width.",
                  .taps = "N = ceil(ratio) trilinear taps along the ellipse's longer axis, linear about the "
                          "centre, at (i - 1/2) / N - 1/2 of s1, i = 1 to N; mean. The specification leaves "
                          "number and places to the implementation: these are ours.",
                  .source = "Direct3D 11.3 functional specification, 7.18.11"},
         .prepare = prepare_bilinear<LinearTaps<ellipse_axis, midpoints>>},
        {.name = "aniso-elliptical",
         .card =
             {.footprint = "The ellipse of the Jacobian's singular values R >= r. Lookups stand on a line of "
                           "length L = "
                           "2 (R - a r / 2) along its longer axis, a: maximum anisotropy; where L is not "
                           "above 0 or not "
                           "finite there is one.",
              .lod = "That of aniso-d3d11, in each lookup.",
              .taps =
                  "Five lookups of aniso-d3d11 with the pixel's own steps, at i L / 5, i = -2 to 2, linear "
                  "about the centre; weight exp(-|i| / 5), divided by the sum.",
              .source =
                  "Mavridis and Papaioannou 2011, as their demonstration program 0.6 has it (approximate "
                  "EWA, 6 probes, of which it takes 5); there a is 16 and the lookup the hardware's"},
         .prepare = prepare_bilinear<EllipseOfLookups>},
        {.name = "aniso-ray-cone",
         .card =
             {.footprint =
                  "The cone of trilinear-ray-cone, r = w / 2. On the surface it covers an ellipse with the "
                  "semi-axes r / |n . d| along the ray's projection and r across. Their images g1 and g2 on "
                  "the texture give steps 2 g1 and 2 g2: P_max the longer of them, P_min the shorter; N = "
                  "min(ceil(P_max / P_min), maximum anisotropy), 1 where P_max is 0.",
              .lod = extension_lod,
              .taps = midpoint_taps,
              .source = "Akenine-Moller, Crassin, Boksansky, Belcour, Panteleev and Wright 2021, with its "
                        "erratum; it leaves the taps to the hardware: these are those of aniso-midpoint"},
         .prepare = prepare_bilinear<LinearTaps<cone_axis, midpoints>>}};
}

}  // namespace zproof::texture
