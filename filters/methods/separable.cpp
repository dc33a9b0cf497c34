#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "filters/methods/families.h"
#include "filters/methods/mip_reads.h"

namespace zproof::texture {

namespace {

/// What the four texels before and behind a place of a line weigh.
struct FourTaps {
    std::int64_t first = 0;
    std::array<double, 4> weights{};
};

/// A function of the distance from a texel's centre, 0 from 2 on.
using Profile = double (*)(double);

/// Keys 1981 with a = -1/2.
double catmull_rom(double d) {
    return d < 1 ? 1 + d * d * (1.5 * d - 2.5) : 2 + d * (-4 + d * (2.5 - d / 2));
}

double cubic_b_spline(double d) {
    return d < 1 ? 2 / 3.0 + d * d * (d / 2 - 1) : (2 - d) * (2 - d) * (2 - d) / 6;
}

double sinc(double x) { return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); }
double lanczos2(double d) { return sinc(d) * sinc(d / 2); }

double gaussian(double d) { return std::exp(-2 * d * d) - std::exp(-8.0); }

/// The weights of a profile sum to 1 anywhere, or are divided by their sum.
enum class WeightSum { one, divided };

template <Profile profile, WeightSum sum>
FourTaps four_taps(double place) {
    const double between = place_on_line(place) - 0.5, low = std::floor(between);
    FourTaps taps{std::int64_t(low) - 1, {}};
    for (std::size_t i = 0; i < 4; ++i) taps.weights[i] = profile(std::abs(low + double(i) - 1 - between));
    if constexpr (sum == WeightSum::divided) {
        const double all = std::accumulate(taps.weights.begin(), taps.weights.end(), 0.0);
        for (double& weight : taps.weights) weight /= all;
    }
    return taps;
}

using FourTapsAt = FourTaps (*)(double place);

constexpr FourTapsAt b_spline_taps = four_taps<cubic_b_spline, WeightSum::one>;

/// Sixteen texels, weighted by the product of both axes' weights.
void read_sixteen(const LinearImage& image, const Addressing& wrap, const FourTaps& u, const FourTaps& v,
                  Tap tap, auto&& read) {
    const double whole = tap.weight;
    for (int down = 0; down < 4; ++down)
        for (int right = 0; right < 4; ++right) {
            tap.column = wrapped(wrap.u, u.first + right, image.width);
            tap.row = wrapped(wrap.v, v.first + down, image.height);
            tap.weight = whole * u.weights[std::size_t(right)] * v.weights[std::size_t(down)];
            read(tap);
        }
}

template <FourTapsAt taps_at>
struct SixteenTexels {
    LinearImage image;
    Addressing wrap;

    void operator()(const Footprint& footprint, auto&& read) const {
        read_sixteen(image, wrap, taps_at(footprint.centre.x), taps_at(footprint.centre.y), Tap{.weight = 1},
                     read);
    }
    glm::dvec4 value(const Tap& tap) const { return glm::dvec4{image.at(tap.column, tap.row)}; }
};

/// Four weights as two linear reads: the places at which the line's linear interpolation gives w0 a + w1 b
/// over w0 + w1, and what either read weighs.
struct TwoReads {
    std::array<double, 2> places{}, weights{};

    explicit TwoReads(const FourTaps& taps) {
        for (std::size_t pair = 0; pair < 2; ++pair) {
            const double before = taps.weights[2 * pair], behind = taps.weights[2 * pair + 1];
            weights[pair] = before + behind;
            places[pair] = double(taps.first) + 2.0 * double(pair) + 0.5 + behind / (before + behind);
        }
    }
};

/// Reads the sixteen texels by four bilinear reads.
struct FourBilinearReads {
    LinearImage image;
    Addressing wrap;

    void operator()(const Footprint& footprint, auto&& read) const {
        const TwoReads u{b_spline_taps(footprint.centre.x)}, v{b_spline_taps(footprint.centre.y)};
        for (std::size_t down = 0; down < 2; ++down)
            for (std::size_t right = 0; right < 2; ++right)
                read_bilinear(image, wrap, {u.places[right], v.places[down]},
                              Tap{.weight = u.weights[right] * v.weights[down]}, read);
    }
    glm::dvec4 value(const Tap& tap) const { return glm::dvec4{image.at(tap.column, tap.row)}; }
};

template <class Rule>
Sampler prepare_level_zero(const LinearImage& image, const FilterOptions& options) {
    return sampler(Rule{image, options.addressing}, {level_zero(image)});
}

/// Trilinear, its read of level 0 the B-spline's.
struct Smart {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const double lod = mips.in_chain(lod_gl_maximum(footprint));
        if (lod >= 1) return mips.trilinear(lod, footprint.centre, 1, read);
        read_sixteen(mips.levels[0], mips.options.addressing, b_spline_taps(footprint.centre.x),
                     b_spline_taps(footprint.centre.y), Tap{.weight = 1 - lod}, read);
        if (lod > 0) mips.bilinear(1, footprint.centre, lod, read);
    }
};

Method of_level_zero(std::string name, std::string taps, std::string source,
                     decltype(Method::prepare) prepare) {
    return {.name = std::move(name),
            .card = {.footprint = "The pixel's centre.",
                     .lod = "Level 0.",
                     .taps = std::move(taps),
                     .source = std::move(source)},
            .prepare = std::move(prepare)};
}

constexpr const char* leaves_range = " Weights may be negative: the result may leave the texels' range.";

}  // namespace

std::vector<Method> separable_methods() {
    return {
        of_level_zero("bicubic",
                      std::string{"The sixteen texels around the place, weighted by the product of two "
                                  "Catmull-Rom cubics (a = -1/2)."} +
                          leaves_range,
                      "Keys 1981; Catmull and Rom 1974",
                      prepare_level_zero<SixteenTexels<four_taps<catmull_rom, WeightSum::one>>>),
        of_level_zero(
            "bspline",
            "The sixteen texels around the place, weighted by the product of two cubic B-splines: it "
            "does not pass through the texels.",
            "Hou and Andrews 1978; without their prefilter",
            prepare_level_zero<SixteenTexels<b_spline_taps>>),
        of_level_zero(
            "bspline-bilinear",
            "The texels and weights of bspline by four bilinear reads. Along either axis the weights "
            "w0 to w3 make two reads, w1 / (w0 + w1) behind the first texel and w3 / (w2 + w3) behind "
            "the third, of weights w0 + w1 and w2 + w3.",
            "Sigg and Hadwiger 2005, GPU Gems 2, chapter 20", prepare_level_zero<FourBilinearReads>),
        of_level_zero("lanczos2",
                      std::string{"The sixteen texels around the place, weighted by the product of sinc(x) "
                                  "sinc(x / 2) of either axis, divided by their sum."} +
                          leaves_range,
                      "Duchon 1979; Turkowski 1990",
                      prepare_level_zero<SixteenTexels<four_taps<lanczos2, WeightSum::divided>>>),
        of_level_zero(
            "gaussian",
            "The sixteen texels around the place, weighted by the product of exp(-2 x^2) - exp(-8) of "
            "either axis, divided by their sum.",
            "pbrt-v3, GaussianFilter of alpha 2 and radius 2, in texels",
            prepare_level_zero<SixteenTexels<four_taps<gaussian, WeightSum::divided>>>),
        {.name = "smart-bicubic",
         .card = {.footprint = "The longer of the pixel's two steps.",
                  .lod = "log2 of its length in texels.",
                  .taps =
                      "In the two levels around the LOD, weighted by its fraction: in level 0 as bspline, in "
                      "others bilinear.",
                  .source = "OpenImageIO, InterpSmartBicubic, on OpenGL's LOD"},
         .prepare = prepare_mipped<Smart>}};
}

}  // namespace zproof::texture
