#include <algorithm>

#include "texture/methods/families.h"
#include "texture/methods/tap_rule.h"
#include "texture/mip_chain.h"

namespace zproof::texture {

namespace {

/// OpenGL 4.6 core, 8.14.1: the longer of the two steps.
double gl_maximum(const Footprint& f) {
    return std::log2(std::max(glm::length(f.per_x), glm::length(f.per_y)));
}

struct TrilinearRule {
    std::vector<LinearImage> levels;
    FilterOptions options;

    void operator()(const Footprint& footprint, auto&& read) const {
        const double coarsest = double(levels.size()) - 1;
        const double biased =
            std::clamp(gl_maximum(footprint) + options.lod_bias, options.lod_min, options.lod_max);
        const double lod = std::clamp(biased, 0.0, coarsest), finer = std::floor(lod), share = lod - finer;
        read_level(int(finer), footprint, 1 - share, read);
        if (share > 0) read_level(int(finer) + 1, footprint, share, read);
    }
    void read_level(int level, const Footprint& footprint, double weight, auto&& read) const {
        const LinearImage& image = levels[std::size_t(level)];
        const glm::dvec2 scale{double(image.width) / levels[0].width,
                               double(image.height) / levels[0].height};
        read_bilinear(image, options.addressing, footprint.centre * scale,
                      Tap{.image = level, .weight = weight}, read);
    }
    glm::dvec4 value(const Tap& tap) const {
        return glm::dvec4{levels[std::size_t(tap.image)].at(tap.column, tap.row)};
    }
};

Sampler prepare(const LinearImage& image, const FilterOptions& options) {
    TrilinearRule rule{mip_chain(image, options.mip_kernel), options};
    std::vector<StoredImage> stored;
    for (const LinearImage& level : rule.levels)
        stored.push_back({level.width, level.height, sizeof(glm::vec4), {}});
    return sampler(std::move(rule), std::move(stored));
}

}  // namespace

std::vector<Method> mip_methods() {
    return {{.name = "trilinear-gl",
             .card = {.footprint = "The longer of the pixel's two steps.",
                      .lod = "log2 of its length in texels.",
                      .taps = "Bilinear in the two levels around the LOD, blended by its fraction.",
                      .source = "OpenGL 4.6 core, 8.14"},
             .prepare = prepare}};
}

}  // namespace zproof::texture
