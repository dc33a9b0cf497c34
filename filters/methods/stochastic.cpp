#include <bit>
#include <cstdint>

#include "filters/methods/families.h"
#include "filters/methods/lod.h"
#include "filters/methods/tap_rule.h"
#include "filters/stored/mip_chain.h"
#include "filters/stored/void_and_cluster.h"
#include "math/mixed.h"

namespace zproof::texture {

namespace {

enum Decision { column, row, level };

/// White noise: a number of its own for every seed, pixel, sample and decision.
class WhiteNoise {
  public:
    WhiteNoise(std::uint32_t seed, const glm::dvec2& centre_raster, int sample)
        : sample_{mixed(mixed(mixed(seed ^ mixed(bits(centre_raster.x))) ^ bits(centre_raster.y)) ^
                        std::uint64_t(sample))} {}

    /// 1, the second of two, with the probability of its share.
    int second(Decision decision, double share) { return number(decision) < share ? 1 : 0; }

  private:
    /// In [0, 1), a multiple of 2^-53.
    double number(Decision decision) const {
        return double(mixed(sample_ ^ std::uint64_t(decision)) >> 11) * 0x1p-53;
    }
    static std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

    std::uint64_t sample_;
};

/// A number for every pixel and frame. What is left of it after a decision takes the next one.
class OneNumber {
  public:
    explicit OneNumber(double number) : number_(number) {}

    int second(Decision, double share) {
        const bool is_second = number_ < share;
        number_ = is_second ? number_ / share : (number_ - share) / (1 - share);
        return is_second ? 1 : 0;
    }

  private:
    double number_;
};

/// Interleaved gradient noise (Jimenez 2014).
double interleaved_number(std::uint32_t frame, const glm::dvec2& pixel) {
    const glm::dvec2 at = pixel + 5.588238 * double(frame % 64);
    return glm::fract(52.9829189 * glm::fract(0.06711056 * at.x + 0.00583715 * at.y));
}

/// One of the mask's 4096 numbers, in the middle of its step; every frame moves it on by the golden ratio, in
/// 2^-32.
double blue_number(std::uint32_t frame, const glm::dvec2& pixel) {
    const auto cell = [](double at) {
        const double within = at - blue_noise_side * std::floor(at / blue_noise_side);
        return within >= 0 ? std::size_t(within) : 0;  // the first, of a place that is no number
    };
    const std::uint32_t rank = blue_noise_ranks()[cell(pixel.y) * blue_noise_side + cell(pixel.x)];
    return double((rank << 20) + (1u << 19) + frame * 2654435769u) * 0x1p-32;
}

template <double (*number)(std::uint32_t frame, const glm::dvec2& pixel)>
struct FrameNoise : OneNumber {
    FrameNoise(std::uint32_t seed, const glm::dvec2& centre_raster, int sample)
        : OneNumber(number(seed + std::uint32_t(sample), glm::floor(centre_raster))) {}
};

/// One texel a sample, of the levels around the LOD. Without a chain there is one level.
template <class Noise>
struct OneTexelRule {
    std::vector<LinearImage> levels;
    FilterOptions options;

    void operator()(const Footprint& footprint, auto&& read) const {
        const double lod = lod_in_chain(lod_gl_maximum(footprint), options, levels.size());
        const int finer = int(lod);  // rounded down: it is not negative
        for (int sample = 0; sample < options.samples; ++sample) {
            Noise noise{options.seed, footprint.centre_raster, sample};
            const Tap tap{.image = finer + noise.second(level, lod - finer), .weight = 1.0 / options.samples};
            read(drawn(tap, place_in(tap.image, footprint.centre), noise));
        }
    }
    glm::dvec4 value(const Tap& tap) const {
        return glm::dvec4{levels[std::size_t(tap.image)].at(tap.column, tap.row)};
    }

  private:
    glm::dvec2 place_in(int of_level, const glm::dvec2& place) const {
        const LinearImage &image = levels[std::size_t(of_level)], &finest = levels[0];
        return place * glm::dvec2{double(image.width) / finest.width, double(image.height) / finest.height};
    }
    Tap drawn(Tap tap, const glm::dvec2& place, Noise& noise) const {
        const LinearImage& image = levels[std::size_t(tap.image)];
        const glm::dvec2 between{place_on_line(place.x) - 0.5, place_on_line(place.y) - 0.5},
            low = glm::floor(between), share = between - low;
        tap.column =
            wrapped(options.addressing.u, std::int64_t(low.x) + noise.second(column, share.x), image.width);
        tap.row =
            wrapped(options.addressing.v, std::int64_t(low.y) + noise.second(row, share.y), image.height);
        return tap;
    }
};

Sampler prepare_stochastic_bilinear(const LinearImage& image, const FilterOptions& options) {
    return sampler(OneTexelRule<WhiteNoise>{{image}, options}, {level_zero(image)});
}

template <class Noise>
Sampler prepare_stochastic_trilinear(const LinearImage& image, const FilterOptions& options) {
    return sampler(OneTexelRule<Noise>{mip_chain(image, options), options},
                   stored_mip_chain(image, options.mip_kernel, options.addressing));
}

/// The mask is made here, not by the first lookup.
Sampler prepare_stochastic_blue(const LinearImage& image, const FilterOptions& options) {
    blue_noise_ranks();
    return prepare_stochastic_trilinear<FrameNoise<blue_number>>(image, options);
}

constexpr const char* noise_rule =
    "Each decision has a number in [0, 1) of its own, a hash of seed, pixel, sample and decision: white "
    "noise.";
constexpr const char* papers =
    "Fajardo, Wronski, Salvi and Pharr 2023, Stochastic Texture Filtering; Pharr, Wronski, Salvi and Fajardo "
    "2024, Filtering After Shading With Stochastic Texture Filtering";

}  // namespace

std::vector<Method> stochastic_methods() {
    return {
        {.name = "stochastic-bilinear",
         .card = {.footprint = "The pixel's centre.",
                  .lod = "Level 0.",
                  .taps = std::string{"The mean of spp samples. A sample is one of the four texels whose "
                                      "centres surround the place: column and row are decided separately, "
                                      "each with the probability of its bilinear weight. "} +
                          noise_rule + " The expectation is bilinear.",
                  .source = papers},
         .prepare = prepare_stochastic_bilinear},
        {.name = "stochastic-trilinear",
         .card = {.footprint = "The longer of the pixel's two steps.",
                  .lod = "log2 of its length in texels.",
                  .taps = std::string{"The mean of spp samples. A sample is one texel: of the two levels "
                                      "around the LOD the coarser with the probability of the LOD's "
                                      "fraction, there as stochastic-bilinear. "} +
                          noise_rule + " The expectation is trilinear-gl.",
                  .source = papers},
         .prepare = prepare_stochastic_trilinear<WhiteNoise>},
        {.name = "stochastic-interleaved",
         .card =
             {.footprint = "The longer of the pixel's two steps.",
              .lod = "log2 of its length in texels.",
              .taps =
                  "The mean of spp samples, the frames of an accumulation. A sample is one texel, decided "
                  "by one number: frac(52.9829189 frac(0.06711056 (x + o) + 0.00583715 (y + o))) of pixel "
                  "(x, y), o = 5.588238 ((seed + sample) mod 64), interleaved gradient noise. Level, "
                  "column and row are decided in this order. A number q below the second one's share s "
                  "takes it and leaves q / s for the next decision; any other takes the first one and "
                  "leaves (q - s) / (1 - s). Averaged over frames and neighbouring pixels it nears "
                  "trilinear-gl.",
              .source = "Jimenez 2014, Next Generation Post Processing in Call of Duty; Fajardo, Wronski, "
                        "Salvi and Pharr 2023, Stochastic Texture Filtering, for one number for all"},
         .prepare = prepare_stochastic_trilinear<FrameNoise<interleaved_number>>},
        {.name = "stochastic-blue",
         .card =
             {.footprint = "The longer of the pixel's two steps.",
              .lod = "log2 of its length in texels.",
              .taps =
                  "The mean of spp samples, the frames of an accumulation. A sample is one texel, decided as "
                  "by stochastic-interleaved, but by another number: frac((r + 1/2) / 4096 + (seed + sample) "
                  "2654435769 / 2^32). r is the rank of pixel (x mod 64, y mod 64) in a void-and-cluster "
                  "mask of 64 x 64 (filters/stored/void_and_cluster.h). Every frame moves the number on by "
                  "the "
                  "golden ratio. Averaged over frames and neighbouring pixels it nears trilinear-gl.",
              .source = "Ulichney 1993, The void-and-cluster method for dither array generation; Pharr, "
                        "Wronski, Salvi and Fajardo 2024, Filtering After Shading With Stochastic Texture "
                        "Filtering, for blue noise; mask and frames are ours"},
         .prepare = prepare_stochastic_blue}};
}

}  // namespace zproof::texture
