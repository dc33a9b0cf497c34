#include <cmath>

#include "texture/methods/bilinear_rule.h"
#include "texture/methods/families.h"

namespace zproof::texture {

namespace {

/// Equal trilinear taps on a line through the footprint's centre.
struct Line {
    glm::dvec2 whole{0};  ///< texels, from one end to the other
    int taps = 1;
    double width = 0;  ///< texels that each tap covers: its LOD is the log2
};

constexpr reads::TapSpacing literal_places{.first = 1, .more = 1}, midpoints{.first = 0.5, .more = 0};

int whole_taps(double ratio, double most) {
    return std::isfinite(ratio) ? std::max(1, int(std::ceil(std::min(ratio, most)))) : int(most);
}

Line longer_step(const Footprint& f, int max_anisotropy) {
    const double x = glm::length(f.per_x), y = glm::length(f.per_y);
    const double longer = std::max(x, y), shorter = std::min(x, y);
    const int taps = longer > 0 ? whole_taps(longer / shorter, max_anisotropy) : 1;
    return {x > y ? f.per_x : f.per_y, taps, longer / taps};
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
struct Taps {
    static constexpr reads::TapSpacing spacing = on_line;

    LineOfTaps line(const MipReads& mips, const Footprint& footprint) const {
        const Line line = line_of(footprint, mips.options.max_anisotropy);
        return {line.whole, line.taps, mips.in_chain(std::log2(line.width))};
    }
};

constexpr const char* longer_step_footprint =
    "The longer of the pixel's two steps, P_max (the one in y where they are equal), by the shorter, P_min; "
    "N = "
    "min(ceil(P_max / P_min), maximum anisotropy), 1 where P_max is 0.";
constexpr const char* longer_step_lod = "log2(P_max / N).";

}  // namespace

std::vector<Method> anisotropic_methods() {
    return {
        {.name = "aniso-ext",
         .card = {.footprint = longer_step_footprint,
                  .lod = longer_step_lod,
                  .taps = "N trilinear taps along the longer step, linear about the centre, at i / (N + 1) - "
                          "1/2 of it, i = 1 to N; mean.",
                  .source = "EXT_texture_filter_anisotropic, to the letter"},
         .prepare = prepare_bilinear<Taps<longer_step, literal_places>>},
        {.name = "aniso-midpoint",
         .card = {.footprint = longer_step_footprint,
                  .lod = longer_step_lod,
                  .taps =
                      "N trilinear taps along the longer step, linear about the centre, at (i - 1/2) / N - "
                      "1/2 of it, i = 1 to N; mean.",
                  .source = "EXT_texture_filter_anisotropic, taps at the middles of N equal parts"},
         .prepare = prepare_bilinear<Taps<longer_step, midpoints>>},
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
         .prepare = prepare_bilinear<Taps<ellipse_axis, midpoints>>}};
}

}  // namespace zproof::texture
