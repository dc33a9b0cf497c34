#include "filters/methods/families.h"
#include "filters/methods/tap_rule.h"

namespace zproof::texture {

namespace {

enum class TexelRead { nearest, bilinear };

/// The mean of level 0 at n x n places of the pixel.
template <TexelRead kind>
struct SupersampleRule {
    LinearImage image;
    FilterOptions options;

    void operator()(const Footprint& footprint, auto&& read) const {
        const int n = options.subdivisions;
        for (int down = 0; down < n; ++down)
            for (int right = 0; right < n; ++right) {
                const glm::dvec2 within{(right + 0.5) / n - 0.5, (down + 0.5) / n - 0.5};
                read_at(footprint.at(footprint.centre_raster + within), 1.0 / (n * n), read);
            }
    }
    void read_at(const glm::dvec2& place, double weight, auto&& read) const {
        const Tap whole{.image = 0, .weight = weight};
        if constexpr (kind == TexelRead::nearest)
            read_nearest(image, options.addressing, place, whole, read);
        else
            read_bilinear(image, options.addressing, place, whole, read);
    }
    glm::dvec4 value(const Tap& tap) const { return glm::dvec4{image.at(tap.column, tap.row)}; }
};

template <TexelRead kind>
Sampler prepare_supersample(const LinearImage& image, const FilterOptions& options) {
    return sampler(SupersampleRule<kind>{image, options}, {level_zero(image)});
}

Method method(std::string name, std::string taps, decltype(Method::prepare) prepare) {
    return {.name = std::move(name),
            .card = {.footprint = "The centres of n x n equal squares of the pixel, each seen through the "
                                  "surface's own perspective (n: subdivisions).",
                     .lod = "Level 0.",
                     .taps = std::move(taps),
                     .source = "brute force"},
            .prepare = std::move(prepare)};
}

}  // namespace

std::vector<Method> supersample_methods() {
    return {method("supersample-nearest", "The texel that holds each place; mean.",
                   prepare_supersample<TexelRead::nearest>),
            method("supersample-bilinear", "Bilinear at each place; mean.",
                   prepare_supersample<TexelRead::bilinear>)};
}

}  // namespace zproof::texture
