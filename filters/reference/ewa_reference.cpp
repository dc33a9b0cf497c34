#include "filters/reference/line_of_taps.h"

namespace zproof::oracle::filter_reference {

namespace {

/// Conjugate radii of the ellipse, texels of level 0; LOD is log2 of `shortness`.
struct Radii {
    TexelInterval longer, shorter;
    Interval shortness;
};

struct Ellipse {
    Radii radii;
    TexelInterval centre;
};

/// A u^2 + B u v + C v^2 < 1 inside; in a level's own texels each radius widened by one, in square (Heckbert
/// 1989; pbrt's "+ 1").
struct Conic {
    Interval a, b, c;

    Conic(const TexelInterval& p, const TexelInterval& q) {
        const Interval one{1}, raw_a = square(p.v) + square(q.v) + one,
                               raw_c = square(p.u) + square(q.u) + one;
        const Interval raw_b = Interval{-2} * (p.u * p.v + q.u * q.v);
        // raw_a raw_c - raw_b^2 / 4 without the cancellation: (p x q)^2 + |p|^2 + |q|^2 + 1.
        const Interval f =
            square(p.u * q.v - p.v * q.u) + square(p.u) + square(p.v) + square(q.u) + square(q.v) + one;
        a = raw_a / f, b = raw_b / f, c = raw_c / f;
        reach_u = square_root(raw_c), reach_v = square_root(raw_a);
    }
    Interval at(const Interval& u, const Interval& v) const {
        return a * square(u) + b * (u * v) + c * square(v);
    }

    Interval reach_u, reach_v;  ///< half the sides of the bounding box
};

double falloff(double r2) { return std::exp(-2 * r2) - std::exp(-2.0); }

enum class Profile {
    smooth,  ///< exp(-2 r^2) - exp(-2)
    table,   ///< the same at r^2 = k / 127, k = floor(128 r^2): pbrt's table of 128 entries
    mesa,    ///< exp(-2 r^2) at r^2 = k / 1023, k = floor(1023 r^2): Mesa's table of 1024 entries
};

double mesa_weight(double r2) {
    const double k = std::floor(1023 * std::max(r2, 0.0));
    return k >= 1024 ? 0 : std::exp(-2 * k / 1023);
}

/// Falling in r2, so the ends hold the extremes. From 1 on it is 0 (Mesa: beyond its table).
Interval weight_of(Profile profile, const Interval& r2) {
    const auto value = [&](double r) {
        if (profile == Profile::mesa) return mesa_weight(r);
        if (r >= 1) return 0.0;
        const double at =
            profile == Profile::smooth ? r : std::min(std::floor(128 * std::max(r, 0.0)), 127.0) / 127;
        return falloff(at);
    };
    const Interval w{value(r2.high()), value(r2.low())};
    return w.high() == 0 ? w : Interval{std::max(0.0, w.low() - 0x1p-50), w.high() + 0x1p-50};
}

TexelInterval scaled(const TexelInterval& p, const IntervalImage& level, const IntervalImage& finest) {
    return {p.u * (Interval{double(level.width)} / Interval{double(finest.width)}),
            p.v * (Interval{double(level.height)} / Interval{double(finest.height)})};
}

ColourRange read_ellipse(const Levels& levels, int k, const Ellipse& ellipse, const FilterQuery& q,
                         Profile profile) {
    const IntervalImage &level = levels.at(k), &finest = levels.at(0);
    const Conic conic{scaled(ellipse.radii.longer, level, finest),
                      scaled(ellipse.radii.shorter, level, finest)};
    const TexelInterval place = place_in(level, finest, ellipse.centre, q.precision);
    const Interval half{0.5}, centre_u = place.u - half, centre_v = place.v - half;
    // Mesa's table reaches to r^2 = 1024 / 1023.
    const Interval reach{-1.0005, 1.0005};
    const Interval box_u = centre_u + conic.reach_u * reach, box_v = centre_v + conic.reach_v * reach;
    // So large an ellipse is one that intervals know nothing of (the plane's horizon, or a relaxed rule).
    constexpr double most_texels = 0x1p18;
    if (!((box_u.high() - box_u.low()) * (box_v.high() - box_v.low()) < most_texels)) throw UndecidedSign{};
    std::vector<Interval> weights;
    std::vector<ColourRange> colours;
    const double error = std::exp2(-q.precision.weight_bits);
    for (double row = std::ceil(box_v.low()); row <= box_v.high(); ++row) {
        for (double column = std::ceil(box_u.low()); column <= box_u.high(); ++column) {
            const Interval r2 = conic.at(Interval{column} - centre_u, Interval{row} - centre_v);
            const Interval weight = weight_of(profile, r2);
            if (weight.high() == 0) continue;
            const auto& wrap = levels.settings().wrap;
            const auto& texel = level.at(wrapped_index(wrap.u, std::int64_t(column), level.width),
                                         wrapped_index(wrap.v, std::int64_t(row), level.height));
            weights.push_back(widen(weight, error));
            colours.push_back(around(texel.value, texel.radius));
        }
    }
    return weighted_mean(weights, colours);
}

/// Bias scales the ellipse; an LOD above the greatest allowed scales it down to that one.
Radii biased(const Radii& radii, const Settings& s) {
    const Interval lod = log2(radii.shortness) + Interval{s.lod_bias};
    const Interval excess = larger(lod - Interval{s.lod_max}, Interval{0});
    const Interval scale = exp2(Interval{s.lod_bias} - excess);
    const auto by = [&](const TexelInterval& p) { return TexelInterval{scale * p.u, scale * p.v}; };
    return {by(radii.longer), by(radii.shorter), scale * radii.shortness};
}

/// Two levels around the LOD, blended by its fraction; from the last level on its one texel.
ColourRange read_levels(const Levels& levels, const Radii& unbiased, const FilterQuery& q, Profile profile) {
    const Settings& s = levels.settings();
    const Radii radii = biased(unbiased, s);
    const TexelInterval at = q.footprint().centre;
    const int coarsest = int(levels.count()) - 1;
    const double inf = std::numeric_limits<double>::infinity();
    const Interval raw = widen(log2(radii.shortness), std::exp2(-q.precision.lod_bits) + 0x1p-46);
    const Interval lod = clamped(clamped(raw, std::max(s.lod_min, 0.0), inf), 0, coarsest);
    const auto read = [&](int k) {
        if (k < coarsest) return read_ellipse(levels, k, {radii, at}, q, profile);
        const PermittedColours last = levels.nearest_in(k, at, q.precision);
        return last.front();
    };
    const int first = int(std::floor(lod.low()));
    ColourRange finer = read(first), all = finer;
    if (first == coarsest) return finer;
    for (int k = first; k < coarsest && double(k) <= lod.high(); ++k) {
        const ColourRange coarser = read(k + 1);
        const Interval share = clamped(
            widen(clamped(lod, k, k + 1.0) - Interval{double(k)}, std::exp2(-q.precision.weight_bits)), 0, 1);
        const ColourRange piece = blended(finer, coarser, share);
        all = k == first ? piece : hull(all, piece);
        finer = coarser;
    }
    return all;
}

/// pbrt: the two steps themselves, the shorter one lengthened where they differ by more than the limit.
std::vector<Radii> pbrt_radii(const PixelFootprint& f, double most) {
    const Interval x = length(f.per_x.u, f.per_x.v), y = length(f.per_y.u, f.per_y.v);
    std::vector<Radii> all;
    const auto add = [&](const TexelInterval& a, const Interval& longer, const TexelInterval& b,
                         const Interval& shorter) {
        const Interval scale = larger(Interval{1}, longer / (shorter * Interval{most}));
        all.push_back({a, {scale * b.u, scale * b.v}, larger(shorter, longer / Interval{most})});
    };
    if (x.high() >= y.low()) add(f.per_x, x, f.per_y, y);
    if (y.high() >= x.low()) add(f.per_y, y, f.per_x, x);
    return all;
}

/// The ellipse's own axes, the minor one lengthened to the limit.
std::vector<Radii> true_radii(const PixelFootprint& f, double most) {
    const Axes a = axes(f);
    const TexelInterval d = major_direction(f);
    const Interval minor = larger(a.minor, a.major / Interval{most});
    return {{{a.major * d.u, a.major * d.v}, {minor * -d.v, minor * d.u}, minor}};
}

/// Mesa (softpipe's and llvmpipe's anisotropic filter): the ellipse of the two steps as they are, in the one
/// level at or below the LOD of the shorter step; the limit of anisotropy lengthens the step for the LOD
/// alone.
PermittedColours mesa(const Levels& levels, const FilterQuery& q) {
    const PixelFootprint f = q.footprint();
    const Interval x = square(f.per_x.u) + square(f.per_x.v), y = square(f.per_y.u) + square(f.per_y.v);
    const double most = levels.settings().max_anisotropy;
    const Interval shorter = larger(smaller(x, y), larger(x, y) / Interval{most * most});
    const Interval level =
        level_of(Interval{0.5} * chord_log2(shorter), levels.settings(), levels.count(), q.precision);
    const int coarsest = int(levels.count()) - 1;
    PermittedColours all;
    for (int k = int(std::floor(level.low())); double(k) <= level.high(); ++k) {
        if (k < coarsest)
            all.push_back(read_ellipse(levels, k, {{f.per_x, f.per_y, shorter}, f.centre}, q, Profile::mesa));
        else
            for (const ColourRange& texel : levels.nearest_in(k, f.centre, q.precision)) all.push_back(texel);
    }
    return all;
}

using RadiiOf = std::vector<Radii> (*)(const PixelFootprint&, double);

Definition ewa(const std::string& name, RadiiOf radii_of, Profile profile) {
    return {"ewa-" + name, over_levels([=](const Levels& levels, const FilterQuery& q) {
                PermittedColours all;
                for (const Radii& radii : radii_of(q.footprint(), levels.settings().max_anisotropy))
                    all.push_back(read_levels(levels, radii, q, profile));
                return all;
            })};
}

}  // namespace

std::vector<Definition> ewa_definitions() {
    return {ewa("pbrt", pbrt_radii, Profile::smooth),
            ewa("pbrt-table", pbrt_radii, Profile::table),
            ewa("true", true_radii, Profile::smooth),
            {"ewa-mesa", over_levels(mesa)}};
}

}  // namespace zproof::oracle::filter_reference
