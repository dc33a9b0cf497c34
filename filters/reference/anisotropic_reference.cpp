#include "filters/reference/line_of_taps.h"

namespace zproof::oracle::filter_reference {

namespace {

/// N equal trilinear taps along a line, all at one LOD.
struct Line {
    TexelInterval whole;  ///< texels, from one end to the other
    int taps = 1;
    Interval width;             ///< its log2 is the LOD
    glm::dvec2 whole_raster{};  ///< the same on the picture, pixels; of the pixel's steps alone
};

/// The place of tap i = 1 .. n, in lengths of the line.
using Placement = double (*)(int i, int n);

double to_the_letter(int i, int n) { return double(i) / (n + 1) - 0.5; }
double midpoints(int i, int n) { return (i - 0.5) / n - 0.5; }

Interval level_of_line(const Levels& levels, const FilterQuery& q, const Line& line) {
    return level_of(log2(line.width), levels.settings(), levels.count(), q.precision);
}

ColourRange read_line(const Levels& levels, const FilterQuery& q, const TexelInterval& centre,
                      const Line& line, Placement placement) {
    const Interval level = level_of_line(levels, q, line);
    const double error = std::exp2(-q.precision.tap_bits);
    const int count = line.taps + levels.settings().more_taps;
    std::vector<LineTap> taps;
    for (int i = 1; i <= count; ++i) {
        const double at = placement(i, count);
        taps.push_back({widen(Interval{at}, error + 0x1p-52), Interval{1}});
    }
    return mean_along(centre, line.whole, taps, [&](const TexelInterval& place) {
        return levels.trilinear(level, place, q.precision);
    });
}

ColourRange read_linear(const Levels& levels, const FilterQuery& q, const Line& line, Placement placement) {
    return read_line(levels, q, q.footprint().centre, line, placement);
}

/// Each tap at its own place of the picture.
ColourRange read_projective(const Levels& levels, const FilterQuery& q, const Line& line,
                            Placement placement) {
    const Interval level = level_of_line(levels, q, line);
    const double error = std::exp2(-q.precision.tap_bits);
    const int count = line.taps + levels.settings().more_taps;
    std::vector<ColourRange> colours;
    for (int i = 1; i <= count; ++i) {
        const auto seen_at = [&](double along) {
            return glm::dvec2{q.x + 0.5, q.y + 0.5} + along * line.whole_raster;
        };
        const double at = placement(i, count);
        const TexelInterval place = q.seen.between(seen_at(at - error), seen_at(at + error));
        colours.push_back(levels.trilinear(level, place, q.precision));
    }
    return weighted_mean(std::vector<Interval>(colours.size(), Interval{1}), colours);
}

/// EXT_texture_filter_anisotropic: N = min(ceil(P_max / P_min), most), LOD = log2(P_max / N). Where it is
/// unclear which step is longer, or what the ceiling is, every case is a candidate.
std::vector<Line> along_longer_step(const PixelFootprint& f, int most) {
    const Interval x = length(f.per_x.u, f.per_x.v), y = length(f.per_y.u, f.per_y.v);
    std::vector<Line> lines;
    const auto add = [&](const TexelInterval& step, const Interval& longer, const Interval& shorter,
                         const glm::dvec2& axis) {
        const Interval ratio = larger(longer / shorter, Interval{1});
        for (const int n : ceilings(ratio, most))
            lines.push_back({step, n, longer / Interval{double(n)}, axis});
    };
    if (x.high() >= y.low()) add(f.per_x, x, y, {1, 0});
    if (y.high() >= x.low()) add(f.per_y, y, x, {0, 1});
    return lines;
}

/// Vulkan, "Scale Factor Operation" and "LOD Operation": LOD = log2(rho_max / eta), eta = min(rho_max /
/// rho_min, most), so rho_max / eta is the larger of rho_min and rho_max / most.
std::vector<Line> by_vulkan(const PixelFootprint& f, int most) {
    const Interval x = length(f.per_x.u, f.per_x.v), y = length(f.per_y.u, f.per_y.v);
    const Interval width = larger(smaller(x, y), larger(x, y) / Interval{double(most)});
    std::vector<Line> lines = along_longer_step(f, most);
    for (Line& line : lines) line.width = width;
    return lines;
}

/// Direct3D 11.3, 7.18.11: the ellipse's axes; a ratio beyond the limit widens the minor one; a minor axis
/// below one texel asks for fewer taps.
std::vector<Line> along_ellipse(const PixelFootprint& f, int most) {
    const Axes axes_of = axes(f);
    const Interval limit{double(most)}, one{1};
    const Interval raw = axes_of.major / axes_of.minor;
    const Interval minor = larger(axes_of.minor, axes_of.major / limit), ratio = smaller(raw, limit);
    const Interval taps = larger(one, smaller(ratio, ratio * minor));
    const TexelInterval direction = major_direction(f);
    std::vector<Line> lines;
    for (const int n : ceilings(taps, most))
        lines.push_back({{axes_of.major * direction.u, axes_of.major * direction.v}, n, minor});
    return lines;
}

/// Mavridis and Papaioannou 2011: five lookups along the ellipse's longer axis, L / 5 from one to the next,
/// each a line of taps by itself. At L = 0 all five are one.
PermittedColours elliptical(const Levels& levels, const FilterQuery& q) {
    const PixelFootprint f = q.footprint();
    const Axes axes_of = axes(f);
    const int most = levels.settings().max_anisotropy;
    const Interval length_of_line =
        larger(Interval{0}, Interval{2} * axes_of.major - Interval{double(most)} * axes_of.minor);
    const TexelInterval direction = major_direction(f), step{length_of_line / Interval{5} * direction.u,
                                                             length_of_line / Interval{5} * direction.v};
    const Interval error{-std::exp2(-q.precision.tap_bits), std::exp2(-q.precision.tap_bits)};
    PermittedColours all;
    for (const Line& line : along_ellipse(f, most)) {
        std::vector<LineTap> lookups;
        for (const int i : {-2, -1, 0, 1, 2})
            lookups.push_back(
                {Interval{double(i)} + error, exp(Interval{double(-std::abs(i))} / Interval{5})});
        all.push_back(mean_along(f.centre, step, lookups, [&](const TexelInterval& place) {
            return read_line(levels, q, place, line, midpoints);
        }));
    }
    return all;
}

/// The pixel's steps are the ellipse's whole axes, 2 g1 and 2 g2 (erratum of Akenine-Moller et al. 2021).
PermittedColours by_cone(const Levels& levels, const FilterQuery& q) {
    const auto [width, along, across] = q.seen.cone(q.x, q.y);
    const auto whole = [](const TexelInterval& semi_axis) {
        return TexelInterval{Interval{2} * semi_axis.u, Interval{2} * semi_axis.v};
    };
    const PixelFootprint f{q.footprint().centre, whole(along), whole(across)};
    PermittedColours all;
    for (const Line& line : along_longer_step(f, levels.settings().max_anisotropy))
        all.push_back(read_linear(levels, q, line, midpoints));
    return all;
}

using Lines = std::vector<Line> (*)(const PixelFootprint&, int);
using ReadLine = ColourRange (*)(const Levels&, const FilterQuery&, const Line&, Placement);

Definition anisotropic_definition(const std::string& name, Lines lines, Placement placement,
                                  ReadLine read = read_linear) {
    return {"aniso-" + name, over_levels([=](const Levels& levels, const FilterQuery& q) {
                PermittedColours all;
                for (const Line& line : lines(q.footprint(), levels.settings().max_anisotropy))
                    all.push_back(read(levels, q, line, placement));
                return all;
            })};
}

/// McCormack, Perry, Farkas and Jouppi 1999: Gaussian-weighted probes along the longer axis.
ColourRange probed(const Levels& levels, const FilterQuery& q, int count, const Interval& major,
                   const Interval& minor_as_is) {
    const PixelFootprint f = q.footprint();
    const Interval wanted = Interval{2} * (major / minor_as_is) - Interval{1}, n{double(count)};
    // Fewer probes than wanted must each be wider. At count = wanted both are the same.
    Interval minor = minor_as_is;
    const Interval widened_minor = Interval{2} * major / (n + Interval{1});
    if (wanted.high() > count) minor = wanted.low() > count ? widened_minor : hull(minor, widened_minor);
    const Interval level = level_of(log2(minor), levels.settings(), levels.count(), q.precision);
    const TexelInterval direction = major_direction(f);
    const Interval length_of_line = Interval{2} * (major - minor);
    const TexelInterval whole{length_of_line * direction.u, length_of_line * direction.v};
    std::vector<LineTap> taps;
    for (int i = 0; i < count; ++i) {
        const double at = count > 1 ? double(i) / (count - 1) - 0.5 : 0;
        const Interval along = widen(Interval{at}, std::exp2(-q.precision.tap_bits) + 0x1p-52);
        const Interval d = along * length_of_line / major;
        taps.push_back({along, exp(Interval{-2} * square(d))});
    }
    return mean_along(f.centre, whole, taps, [&](const TexelInterval& place) {
        return levels.trilinear(level, place, q.precision);
    });
}

PermittedColours feline(const Levels& levels, const FilterQuery& q) {
    const Axes axes_of = axes(q.footprint());
    const Interval one{1}, major = larger(axes_of.major, one), minor = larger(axes_of.minor, one);
    const Interval wanted = Interval{2} * (major / minor) - one;
    const int most = 2 * levels.settings().max_anisotropy - 1;
    const auto count_of = [&](double w) { return int(std::min(std::floor(w + 0.5), double(most))); };
    PermittedColours all;
    for (int n = count_of(std::max(wanted.low(), 1.0)); n <= count_of(wanted.high()); ++n)
        all.push_back(probed(levels, q, n, major, minor));
    return all;
}

}  // namespace

std::vector<Definition> anisotropic_definitions() {
    return {anisotropic_definition("ext", along_longer_step, to_the_letter, read_projective),
            anisotropic_definition("ext-linear", along_longer_step, to_the_letter),
            anisotropic_definition("vulkan", by_vulkan, to_the_letter, read_projective),
            anisotropic_definition("vulkan-linear", by_vulkan, to_the_letter),
            anisotropic_definition("midpoint", along_longer_step, midpoints),
            anisotropic_definition("d3d11", along_ellipse, midpoints),
            {"aniso-elliptical", over_levels(elliptical)},
            {"aniso-ray-cone", over_levels(by_cone)},
            {"aniso-feline", over_levels(feline)}};
}

}  // namespace zproof::oracle::filter_reference
