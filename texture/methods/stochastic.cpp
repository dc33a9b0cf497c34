#include <bit>
#include <cstdint>

#include "math/mixed.h"
#include "texture/lod.h"
#include "texture/methods/families.h"
#include "texture/methods/tap_rule.h"
#include "texture/mip_chain.h"

namespace zproof::texture {

namespace {

/// White noise: a number of its own for every seed, pixel, sample and decision.
class Noise {
  public:
    Noise(std::uint32_t seed, const glm::dvec2& centre_raster)
        : pixel_{mixed(mixed(seed ^ mixed(bits(centre_raster.x))) ^ bits(centre_raster.y))} {}

    /// In [0, 1), a multiple of 2^-53.
    double at(int sample, int decision) const {
        return double(mixed(mixed(pixel_ ^ std::uint64_t(sample)) ^ std::uint64_t(decision)) >> 11) * 0x1p-53;
    }

  private:
    static std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

    std::uint64_t pixel_;
};

/// 1, the second of two, with the probability of its share.
int second(double number, double share) { return number < share ? 1 : 0; }

/// One texel a sample, of the levels around the LOD. Without a chain there is one level.
struct OneTexelRule {
    std::vector<LinearImage> levels;
    FilterOptions options;

    void operator()(const Footprint& footprint, auto&& read) const {
        const double lod = lod_in_chain(lod_gl_maximum(footprint), options, levels.size());
        const int finer = int(lod);  // rounded down: it is not negative
        const Noise noise{options.seed, footprint.centre_raster};
        for (int sample = 0; sample < options.samples; ++sample) {
            const Tap tap{.image = finer + second(noise.at(sample, 2), lod - finer),
                          .weight = 1.0 / options.samples};
            const glm::dvec2 numbers{noise.at(sample, 0), noise.at(sample, 1)};
            read(drawn(tap, place_in(tap.image, footprint.centre), numbers));
        }
    }
    glm::dvec4 value(const Tap& tap) const {
        return glm::dvec4{levels[std::size_t(tap.image)].at(tap.column, tap.row)};
    }

  private:
    glm::dvec2 place_in(int level, const glm::dvec2& place) const {
        const LinearImage &image = levels[std::size_t(level)], &finest = levels[0];
        return place * glm::dvec2{double(image.width) / finest.width, double(image.height) / finest.height};
    }
    Tap drawn(Tap tap, const glm::dvec2& place, const glm::dvec2& numbers) const {
        const LinearImage& image = levels[std::size_t(tap.image)];
        const glm::dvec2 between{place_on_line(place.x) - 0.5, place_on_line(place.y) - 0.5},
            low = glm::floor(between), share = between - low;
        tap.column =
            wrapped(options.addressing.u, std::int64_t(low.x) + second(numbers.x, share.x), image.width);
        tap.row =
            wrapped(options.addressing.v, std::int64_t(low.y) + second(numbers.y, share.y), image.height);
        return tap;
    }
};

Sampler prepare_stochastic_bilinear(const LinearImage& image, const FilterOptions& options) {
    return sampler(OneTexelRule{{image}, options}, {level_zero(image)});
}

Sampler prepare_stochastic_trilinear(const LinearImage& image, const FilterOptions& options) {
    return sampler(OneTexelRule{mip_chain(image, options.mip_kernel, options.addressing), options},
                   stored_mip_chain(image, options.mip_kernel, options.addressing));
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
         .prepare = prepare_stochastic_trilinear}};
}

}  // namespace zproof::texture
