#include <algorithm>
#include <cmath>

#include "filters/methods/families.h"
#include "filters/methods/mip_reads.h"

namespace zproof::texture {

namespace {

/// The footprint as an elliptical weighted average takes it, texels of level 0.
struct Axes {
    glm::dvec2 longer{0}, shorter{0};  ///< conjugate radii of the ellipse
};

Axes steps(const Footprint& f) {
    if (glm::dot(f.per_x, f.per_x) < glm::dot(f.per_y, f.per_y)) return {f.per_y, f.per_x};
    return {f.per_x, f.per_y};
}

/// A u^2 + B u v + C v^2 < 1 within the ellipse of a level, its radii widened by one texel of that level in
/// square: what reconstruction adds.
struct Conic {
    double a, b, c;

    Conic(const glm::dvec2& p, const glm::dvec2& q) {
        const double raw_a = p.y * p.y + q.y * q.y + 1, raw_c = p.x * p.x + q.x * q.x + 1,
                     raw_b = -2 * (p.x * p.y + q.x * q.y), f = raw_a * raw_c - raw_b * raw_b / 4;
        a = raw_a / f, b = raw_b / f, c = raw_c / f;
    }
    double at(double u, double v) const { return a * u * u + b * u * v + c * v * v; }
    /// Half the sides of its bounding box.
    glm::dvec2 reach() const {
        const double determinant = 4 * a * c - b * b;
        return {2 * std::sqrt(c / determinant), 2 * std::sqrt(a / determinant)};
    }
};

/// The weight at a squared radius of 0 to 1.
using Profile = double (*)(double r2);

double gaussian(double r2) { return std::exp(-2 * r2) - std::exp(-2.0); }

/// pbrt's table of 128 entries, entry k at r2 = k / 127, read at floor(128 r2).
double gaussian_table(double r2) {
    static const std::array<double, 128> table = [] {
        std::array<double, 128> entries{};
        for (std::size_t k = 0; k < entries.size(); ++k) entries[k] = gaussian(double(k) / 127);
        return entries;
    }();
    return table[std::min(std::size_t(r2 * 128), std::size_t{127})];
}

/// The texels of one level whose centres lie inside the ellipse.
struct LevelEllipse {
    Conic conic;
    glm::dvec2 centre;  ///< texels of the level, 0 at the first texel's centre

    LevelEllipse(const Axes& axes, const glm::dvec2& place, const glm::dvec2& scale)
        : conic{axes.longer * scale, axes.shorter * scale},
          centre{place_on_line(place.x * scale.x) - 0.5, place_on_line(place.y * scale.y) - 0.5} {}

    /// visit(column, row, squared radius), row by row; at least once, as the radii are at least 1.
    void each(auto&& visit) const {
        const glm::dvec2 reach = conic.reach(), low = glm::ceil(centre - reach),
                         high = glm::floor(centre + reach);
        for (double row = low.y; row <= high.y; ++row)
            for (double column = low.x; column <= high.x; ++column) {
                const double r2 = conic.at(column - centre.x, row - centre.y);
                if (r2 < 1) visit(std::int64_t(column), std::int64_t(row), r2);
            }
    }
};

template <Profile profile>
void read_ellipse(const MipReads& mips, int level, const LevelEllipse& ellipse, double weight, auto&& read) {
    const LinearImage& image = mips.levels[std::size_t(level)];
    const Addressing& wrap = mips.options.addressing;
    std::vector<Tap> inside;
    double sum = 0;
    ellipse.each([&](std::int64_t column, std::int64_t row, double r2) {
        inside.push_back(
            {level, wrapped(wrap.u, column, image.width), wrapped(wrap.v, row, image.height), profile(r2)});
        sum += inside.back().weight;
    });
    for (Tap tap : inside) {
        tap.weight = weight * tap.weight / sum;
        read(tap);
    }
}

/// The ellipse at the LOD of its shorter radius, made no longer than max_anisotropy times that. The user's
/// bias scales the ellipse; an LOD above the user's greatest scales it down to that one.
struct EllipseLevel {
    Axes axes;
    double lod = 0;
};

EllipseLevel select_level(Axes axes, double shorter, const FilterOptions& options) {
    double scale = std::exp2(options.lod_bias), lod = std::log2(shorter) + options.lod_bias;
    if (lod > options.lod_max) {
        scale *= std::exp2(options.lod_max - lod);
        lod = options.lod_max;
    }
    axes.longer *= scale;
    axes.shorter *= scale;
    return {axes, std::max({lod, options.lod_min, 0.0})};
}

/// The two levels around the LOD, weighted by its fraction. From the last level on, and where the footprint
/// is not finite: the last level's one texel.
template <Profile profile>
void read_levels(const MipReads& mips, const EllipseLevel& at, const glm::dvec2& place, auto&& read) {
    const glm::dvec2 extent = glm::abs(at.axes.longer) + glm::abs(at.axes.shorter);
    const bool measurable = std::isfinite(extent.x + extent.y) && at.lod < mips.coarsest();
    const double lod = measurable ? at.lod : mips.coarsest(), finer = std::floor(lod);
    for (const int level : {int(finer), int(finer) + 1}) {
        const double weight = 1 - std::abs(lod - level);
        if (weight <= 0) continue;
        if (level == mips.coarsest())
            mips.nearest(level, place, weight, read);
        else
            read_ellipse<profile>(mips, level, LevelEllipse{at.axes, place, mips.scale(level)}, weight, read);
    }
}

template <Profile profile>
struct Pbrt {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        Axes axes = steps(footprint);
        const double longer = glm::length(axes.longer), most = mips.options.max_anisotropy;
        double shorter = glm::length(axes.shorter);
        if (shorter == 0) return mips.bilinear(0, footprint.centre, 1, read);
        if (shorter * most < longer) {
            axes.shorter *= longer / (shorter * most);
            shorter = longer / most;
        }
        read_levels<profile>(mips, select_level(axes, shorter, mips.options), footprint.centre, read);
    }
};

struct TrueAxes {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const Ellipse axes = ellipse(footprint);
        const glm::dvec2 along = axes.major_direction;
        const double minor = std::max(axes.minor, axes.major / mips.options.max_anisotropy);
        const Axes radii{axes.major * along, minor * glm::dvec2{-along.y, along.x}};
        read_levels<gaussian>(mips, select_level(radii, minor, mips.options), footprint.centre, read);
    }
};

constexpr const char* lod_rule =
    "log2 of the shorter radius in texels. The bias scales the ellipse by 2^bias; a LOD above the greatest "
    "allowed scales the ellipse down to that one; then LODs below the least allowed and below 0 are raised.";

/// What is the same for all: `weights` are those of a texel at squared radius r2.
std::string taps(const std::string& weights) {
    return "In either level around the LOD every texel whose centre lies inside the ellipse. Its squared "
           "radii are widened by one texel of that level (J J^T + I). Weight " +
           weights +
           ", divided by the sum of weights. The levels are blended by the LOD's fraction. The last level is "
           "read "
           "as one texel. At most (4 a + 3)^2 texels of a level are looked at, a: maximum anisotropy.";
}

DefinitionCard pbrt_card(const std::string& weights, std::string source) {
    return {.footprint =
                "The ellipse of which the pixel's two steps are conjugate radii; the shorter step is "
                "lengthened to "
                "1 / maximum anisotropy of the longer one where it is shorter. No shorter step: bilinear in "
                "level 0.",
            .lod = lod_rule,
            .taps = taps(weights),
            .source = std::move(source)};
}

}  // namespace

std::vector<Method> ewa_methods() {
    return {
        {.name = "ewa-pbrt",
         .card = pbrt_card("exp(-2 r2) - exp(-2)",
                           "pbrt-v4, MIPMap::EWA, its table of weights replaced by the "
                           "function; Greene and Heckbert 1986"),
         .prepare = prepare_mipped<Pbrt<gaussian>>},
        {.name = "ewa-pbrt-table",
         .card = pbrt_card("entry floor(128 r2) of 128, of which entry k is exp(-2 k / 127) - exp(-2)",
                           "pbrt-v4, MIPMap::EWA"),
         .prepare = prepare_mipped<Pbrt<gaussian_table>>},
        {.name = "ewa-true",
         .card = {.footprint =
                      "The same ellipse by its own axes, the Jacobian's singular values s1 >= s2; s2 is "
                      "raised to s1 / maximum anisotropy where it is less.",
                  .lod = lod_rule,
                  .taps = taps("exp(-2 r2) - exp(-2)"),
                  .source = "Heckbert 1989, 3.5; Greene and Heckbert 1986; limit of anisotropy and widening "
                            "as in pbrt"},
         .prepare = prepare_mipped<TrueAxes>}};
}

}  // namespace zproof::texture
