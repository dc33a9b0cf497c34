#include "filters/study/published_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "filters/methods/catalogue.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/stored/box_moments.h"
#include "filters/study/claims.h"
#include "filters/study/crow.h"
#include "filters/study/scores.h"
#include "filters/study/study.h"
#include "rasterizer/texturing.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/filters/textures.h"

namespace zproof::study {

namespace {

/// A table read at four corners is the mean over its box; a mip map of a 5 x 5 region is log2(5) - 2 of the
/// way from level 2 to level 3.
std::vector<PublishedFigure> crow_1984() {
    const CrowAnswers answers = crow_answers();
    std::vector<PublishedFigure> figures;
    for (const CrowQuestion& question : answers.questions)
        for (const CrowAnswer& answer : question.answers)
            if (answer.method == "sat-affine" && question.per_x.y == 0 && question.per_y.x == 0)
                figures.push_back({"table's error, " + question.region + " texels", "", 0, answer.rmse, 4,
                                   PublishedAs::identity});
    for (const BetweenLevels& between : answers.levels)
        if (between.side == 5)
            figures.push_back({"level above " + std::to_string(between.level) + " of a side of 5", "levels",
                               0.3219, between.by_logarithm, 4, PublishedAs::identity});
    return figures;
}

/// A sum kept with so many bits behind the leading one, of a format that is never too small.
double kept(double sum, int fraction_bits) {
    if (sum == 0) return 0;
    const double unit = std::exp2(std::floor(std::log2(std::abs(sum))) - fraction_bits);
    return std::nearbyint(sum / unit) * unit;
}

/// Signal over noise of an image that goes through its own summed-area table and comes back texel by texel.
double snr_db(const std::vector<double>& texels, int side, double offset, int fraction_bits) {
    std::vector<double> exact(texels.size()), stored(texels.size());
    const auto at = [side](const std::vector<double>& sums, int x, int y) {
        return x < 0 || y < 0 ? 0.0 : sums[std::size_t(y) * std::size_t(side) + std::size_t(x)];
    };
    double signal = 0, noise = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(side) + std::size_t(x);
            exact[i] =
                texels[i] - offset + at(exact, x - 1, y) + at(exact, x, y - 1) - at(exact, x - 1, y - 1);
            stored[i] = kept(exact[i], fraction_bits);
            const double back =
                stored[i] - at(stored, x - 1, y) - at(stored, x, y - 1) + at(stored, x - 1, y - 1);
            signal += texels[i] * texels[i];
            noise += (back + offset - texels[i]) * (back + offset - texels[i]);
        }
    return 10 * std::log10(signal / noise);
}

/// What is gained where the image's mean is taken from every texel before they are summed.
std::vector<PublishedFigure> hensley_2005() {
    constexpr int side = 256;
    const Image image = filters::pink_noise({side, side});
    std::vector<double> texels;
    double sum = 0;
    for (std::size_t i = 0; i < image.texels.size(); i += 4) {
        texels.push_back(double(image.texels[i]) / 255);
        sum += texels.back();
    }
    struct Format {
        const char* name;
        int fraction_bits;
    };
    std::vector<PublishedFigure> figures;
    for (const auto& [name, bits] : {Format{"s10e5", 10}, Format{"s16e7", 16}})
        figures.push_back(
            {std::string{"gain of the offset, on 1/f noise of 8 bits, "} + name, "dB", 31,
             snr_db(texels, side, sum / double(texels.size()), bits) - snr_db(texels, side, 0, bits), 1,
             PublishedAs::measurement_elsewhere});
    return figures;
}

/// Chebyshev's bound from the moments over boxes of noise: reached where the noise is cut to two values, and
/// never below the share of texels at or above a level.
std::vector<PublishedFigure> lauritzen_2007() {
    constexpr int side = 256;
    const Image noise = filters::pink_noise({side, side});
    texture::LinearImage grey{side, side, {}}, cut{side, side, {}};
    for (std::size_t i = 0; i < noise.texels.size(); i += 4) {
        grey.texels.emplace_back(float(noise.texels[i]) / 256);
        cut.texels.emplace_back(noise.texels[i] < 128 ? 0.0f : 1.0f);
    }
    const texture::MomentTables of_grey{grey, {}, texture::SatStorage::integer},
        of_cut{cut, {}, texture::SatStorage::integer};
    const auto share = [](const texture::LinearImage& image, int left, int top, int size, float level) {
        int above = 0;
        for (int row = top; row < top + size; ++row)
            for (int column = left; column < left + size; ++column) above += image.at(column, row).r >= level;
        return double(above) / (size * size);
    };
    const auto bound = [](const texture::MomentTables& tables, int left, int top, int size, double level) {
        const texture::Moments of_box =
            tables.over({double(left), double(left + size)}, {double(top), double(top + size)});
        return texture::most_at_or_above(of_box.mean.r, of_box.variance.r, level);
    };
    double farthest = 0, lowest = 1;
    for (int i = 0; i < 1000; ++i) {
        const int size = 2 + i % 31, left = 37 * i % (side - size), top = 101 * i % (side - size);
        farthest =
            std::max(farthest, std::abs(bound(of_cut, left, top, size, 1) - share(cut, left, top, size, 1)));
        for (const float level : {0.25f, 0.5f, 0.75f})
            lowest = std::min(
                lowest, bound(of_grey, left, top, size, double(level)) - share(grey, left, top, size, level));
    }
    constexpr PublishedAs identity = PublishedAs::identity;
    return {
        {"two values: the bound's greatest distance from the share", "", 0, farthest, 9, identity},
        {"1/f noise: how far the bound falls below the share", "", 0, std::max(0.0, -lowest), 9, identity}};
}

/// What methods draw of a scene's first view.
class Drawing {
  public:
    Drawing(const std::string& scene, int side)
        : loaded_(generate_filter_scene(scene, side, side)),
          frame_(oracle::exact_visibility(loaded_.scene, loaded_.views[0])) {}

    LinearPicture by(const std::string& method, const texture::FilterOptions& options = {}) const {
        return in_double(rasterizer::filtered(loaded_.scene, loaded_.views[0], frame_,
                                              {.method = *texture::find_method(method), .options = options}));
    }

  private:
    Loaded loaded_;
    Frame frame_;
};

/// Squares of differences, channel by channel.
std::vector<double> square_differences(const LinearPicture& a, const LinearPicture& b) {
    std::vector<double> squares;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const glm::dvec3 d = a.pixels()[i] - b.pixels()[i];
        squares.push_back(glm::dot(d, d));
    }
    return squares;
}

double greatest_difference(const LinearPicture& a, const LinearPicture& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const glm::dvec3 d = glm::abs(a.pixels()[i] - b.pixels()[i]);
        most = std::max({most, d.r, d.g, d.b});
    }
    return most;
}

/// 16 taps, and four bilinear reads at places of their own.
std::vector<PublishedFigure> sigg_hadwiger_2005() {
    const Drawing drawing{"magnification", 128};
    return {{"greatest difference of 16 taps and 4 bilinear reads", "", 0,
             greatest_difference(drawing.by("bspline"), drawing.by("bspline-bilinear")), 7,
             PublishedAs::identity}};
}

struct Ratio {
    double value = 0, standard_error = 0;
};

/// The ratio of two sums over pixels; pixels are drawn independently, though both sums may share draws.
Ratio ratio_of_sums(const std::vector<double>& above, const std::vector<double>& below) {
    const double sum_below = std::accumulate(below.begin(), below.end(), 0.0),
                 value = std::accumulate(above.begin(), above.end(), 0.0) / sum_below;
    double squares = 0;
    for (std::size_t i = 0; i < above.size(); ++i) {
        const double rest = above[i] - value * below[i];
        squares += rest * rest;
    }
    return {value, std::sqrt(squares) / sum_below};
}

/// The mean square distance from the filter that is expected falls as one over the number of samples.
std::vector<PublishedFigure> stochastic_variance() {
    const Drawing drawing{"worked", 256};
    const LinearPicture expected = drawing.by("trilinear-gl");
    const auto variance = [&](int samples) {
        return square_differences(drawing.by("stochastic-trilinear", {.samples = samples}), expected);
    };
    const std::vector<double> of_one = variance(1);
    std::vector<PublishedFigure> figures;
    for (const int samples : {4, 16, 64}) {
        const Ratio ratio = ratio_of_sums(of_one, variance(samples));
        figures.push_back({"variance of 1 sample over that of " + std::to_string(samples), "",
                           double(samples), ratio.value, 2, PublishedAs::expectation, ratio.standard_error});
    }
    return figures;
}

struct WorkedRow {
    const char* label;
    const char* method;
    int subdivisions;
    double psnr;
};

constexpr std::array<WorkedRow, 14> worked_rows{
    {{"nearest", "nearest", 4, 13.88},
     {"bilinear", "bilinear", 4, 14.82},
     {"trilinear-gl", "trilinear-gl", 4, 22.82},
     {"trilinear-area", "trilinear-area", 4, 21.65},
     {"ripmap", "ripmap", 4, 26.82},
     {"sat-affine", "sat-affine", 4, 26.35},
     {"sat-area", "sat-area", 4, 23.83},
     {"sat-moment", "sat-moment", 4, 27.06},
     {"sat-strips:n=16", "sat-strips", 16, 39.52},
     {"aniso-ext-linear", "aniso-ext-linear", 4, 33.54},
     {"aniso-midpoint", "aniso-midpoint", 4, 40.50},
     {"aniso-d3d11", "aniso-d3d11", 4, 40.97},
     {"ewa-pbrt", "ewa-pbrt", 4, 28.28},
     {"supersample-nearest:n=8", "supersample-nearest", 8, 32.08}}};

std::vector<PublishedFigure> worked() {
    const Loaded loaded = generate_filter_scene("worked", 256, 256);
    Plan plan{.methods = {}, .truth = oracle::Reconstruction::nearest, .flicker_steps = 0, .first_row = 56};
    for (const WorkedRow& row : worked_rows)
        plan.methods.push_back(
            {row.label,
             {.method = *texture::find_method(row.method), .options = {.subdivisions = row.subdivisions}}});
    const ProgressSink nobody{.begins = [](const std::string&, double) {},
                              .is_shown = [](const std::string&, const Picture&) {},
                              .wants_to_stop = [] { return false; }};
    const StudyResults results = begun(plan);
    const ViewStudy view = study_view(loaded.scene, loaded.views[0], plan, nobody);
    std::vector<PublishedFigure> figures;
    for (std::size_t i = 0; i < worked_rows.size(); ++i)
        figures.push_back({worked_rows[i].label, "dB", worked_rows[i].psnr,
                           value_of(results, view.methods[i], "interior", "psnr"), 2});
    return figures;
}

}  // namespace

std::optional<bool> is_confirmed(const PublishedFigure& figure) {
    if (figure.as == PublishedAs::measurement_elsewhere) return std::nullopt;
    const double within = figure.as == PublishedAs::expectation ? 3 * figure.standard_error
                                                                : 0.5 * std::pow(10, -figure.decimals);
    return std::abs(figure.ours - figure.published) <= within;
}

std::string verdict_on(const PublishedFigure& figure) {
    const std::optional<bool> confirmed = is_confirmed(figure);
    if (!confirmed) return "other inputs";
    if (figure.as == PublishedAs::measurement) return *confirmed ? "reproduced" : "not reproduced";
    return *confirmed ? "holds" : "does not hold";
}

std::span<const PublishedResult> published_results() {
    static const std::vector<PublishedResult> all{
        {"crow-1984", "A summed-area table read at four corners gives the mean over a box.",
         "Crow 1984, Summed-Area Tables for Texture Mapping", crow_1984},
        {"hensley-2005", "Taking the image's mean away before summing gains up to 31 dB, on their images.",
         "Hensley et al. 2005, Fast Summed-Area Table Generation and its Applications", hensley_2005},
        {"lauritzen-2007",
         "Mean and variance over a box bound the share of texels above a level; two values reach the bound.",
         "Lauritzen 2007, Summed-Area Variance Shadow Maps, GPU Gems 3, chapter 8; Donnelly and Lauritzen "
         "2006",
         lauritzen_2007},
        {"sigg-hadwiger-2005", "A cubic B-spline of 16 taps is four bilinear reads.",
         "Sigg and Hadwiger 2005, Fast Third-Order Texture Filtering, GPU Gems 2, chapter 20",
         sigg_hadwiger_2005},
        {"stochastic-variance", "One random tap has the filter's mean; its variance falls as 1 / samples.",
         "Fajardo et al. 2023, Stochastic Texture Filtering; Pharr et al. 2024, Filtering After Shading",
         stochastic_variance},
        {"worked", "PSNR of fourteen methods on checks of 32 texels to the horizon, against GT-N.",
         "docs/filters.md, The worked set-up", worked},
    };
    return all;
}

}  // namespace zproof::study
