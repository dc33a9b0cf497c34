#include "filters/reference/line_of_taps.h"

namespace zproof::oracle::filter_reference {

namespace {

/// OpenImageIO measures in texture coordinates, where the image is the unit square.
PixelFootprint in_unit_square(PixelFootprint f, const IntervalImage& image) {
    const Interval width{double(image.width)}, height{double(image.height)};
    for (TexelInterval* p : {&f.centre, &f.per_x, &f.per_y}) *p = {p->u / width, p->v / height};
    return f;
}

/// Bias and clamp as they act on log2 of the width in texels of level 0.
Interval adjusted(const Levels& levels, const Interval& width, const FilterPrecision& p) {
    const Interval one{double(std::min(levels.at(0).width, levels.at(0).height))};
    const Settings& s = levels.settings();
    const Interval lod = widen(log2(width * one) + Interval{s.lod_bias},
                               std::exp2(-p.lod_bits) + 0x1p-46 + 16 * std::exp2(-p.coordinate_bits));
    return exp2(clamped(lod, s.lod_min, s.lod_max)) / one;
}

/// The first level on which the width is at most one texel, and the one before it; the coarser one's share is
/// 2 width - 1 there. Where it is unclear which is first, every case is a candidate.
struct Pair {
    int finer = 0, coarser = 0;
    Interval share{0};
};

std::vector<Pair> pairs(const Levels& levels, const Interval& width) {
    std::vector<Pair> all;
    for (int k = 0; k < int(levels.count()); ++k) {
        const IntervalImage& level = levels.at(k);
        const Interval there = width * Interval{double(std::min(level.width, level.height))};
        if (there.low() > 1) continue;
        const Interval share = clamped(Interval{2} * there - Interval{1}, 0, 1);
        all.push_back(k == 0 ? Pair{} : Pair{k - 1, k, share});
        if (there.high() <= 1) return all;
    }
    const int last = int(levels.count()) - 1;
    all.push_back({last, last, Interval{0}});
    return all;
}

ColourRange read(const Levels& levels, const Pair& pair, const TexelInterval& place,
                 const FilterPrecision& p) {
    const Interval share = clamped(widen(pair.share, std::exp2(-p.weight_bits)), 0, 1);
    return blended(levels.bilinear_in(pair.finer, place, p), levels.bilinear_in(pair.coarser, place, p),
                   share);
}

PermittedColours trilinear(const Levels& levels, const FilterQuery& q) {
    const PixelFootprint f = q.footprint();
    const Interval width = exp2(lod(LodRule::largest_coordinate, in_unit_square(f, levels.at(0))));
    PermittedColours all;
    for (const Pair& pair : pairs(levels, adjusted(levels, width, q.precision)))
        all.push_back(read(levels, pair, f.centre, q.precision));
    return all;
}

/// The ellipse's axes as OpenImageIO takes them: an aspect beyond the limit shortens the longer axis and
/// widens the shorter one to meet in the middle.
struct LimitedAxes {
    Interval major, minor, aspect;
};

LimitedAxes limited(const Axes& axes_of, double most) {
    const Interval limit{most}, half{0.5}, raw = axes_of.major / axes_of.minor;
    const Interval major = half * (axes_of.major + axes_of.minor * limit);
    if (raw.low() > most) return {major, major / limit, limit};
    if (raw.high() <= most) return {axes_of.major, axes_of.minor, larger(raw, Interval{1})};
    return {hull(axes_of.major, major), hull(axes_of.minor, major / limit), smaller(raw, limit)};
}

/// Taps at 2 (i + 1/2) / n - 1 of (major - minor), i = 0 .. n - 1, weights exp(-2 x^2) with
/// x = place major / (2 (major - minor)).
ColourRange read_line(const Levels& levels, const FilterQuery& q, const LimitedAxes& axes_of,
                      const Pair& pair, int n) {
    const PixelFootprint f = q.footprint();
    if (n == 1) return read(levels, pair, f.centre, q.precision);
    const IntervalImage& image = levels.at(0);
    const TexelInterval direction = major_direction(in_unit_square(f, image));
    const Interval reach = axes_of.major - axes_of.minor, half{0.5};
    const TexelInterval along{reach * direction.u * Interval{double(image.width)},
                              reach * direction.v * Interval{double(image.height)}};
    std::vector<LineTap> taps;
    for (int i = 0; i < n; ++i) {
        const Interval at =
            widen(Interval{2 * (i + 0.5) / n - 1}, std::exp2(-q.precision.tap_bits) + 0x1p-51);
        taps.push_back({at, exp(Interval{-2} * square(half * at * axes_of.major / reach))});
    }
    return mean_along(f.centre, along, taps,
                      [&](const TexelInterval& place) { return read(levels, pair, place, q.precision); });
}

PermittedColours anisotropic(const Levels& levels, const FilterQuery& q) {
    const PixelFootprint f = q.footprint();
    const double most = levels.settings().max_anisotropy;
    const IntervalImage& image = levels.at(0);
    const LimitedAxes axes_of = limited(axes(in_unit_square(f, image)), most);
    const Interval largest{double(std::max(image.width, image.height))};
    PermittedColours all;
    for (const Pair& pair : pairs(levels, adjusted(levels, axes_of.minor, q.precision))) {
        Interval aspect = axes_of.aspect;
        const Interval texels = axes_of.minor * largest;
        // A minor axis below half a texel of level 0: no more taps than texels ask for.
        if (pair.coarser == 0 && texels.low() < 0.5) {
            const Interval fewer = clamped(Interval{2} * axes_of.major * largest, 1, most);
            aspect = texels.high() < 0.5 ? fewer : hull(aspect, fewer);
        }
        const auto count_of = [](double a) { return std::max(1, int(2 * a - 1)); };
        for (int n = count_of(aspect.low()); n <= count_of(aspect.high()); ++n)
            all.push_back(read_line(levels, q, axes_of, pair, n));
    }
    return all;
}

}  // namespace

std::vector<Definition> openimageio_definitions() {
    return {{"trilinear-oiio", over_levels(trilinear)}, {"aniso-oiio", over_levels(anisotropic)}};
}

}  // namespace zproof::oracle::filter_reference
