#include <algorithm>

#include "filters/methods/families.h"
#include "filters/methods/lod.h"
#include "filters/methods/tap_rule.h"
#include "filters/stored/mip_chain.h"

namespace zproof::texture {

namespace {

/// How an axis is halved: halvings[k] makes k + 1 of k, made_of[k] tells k in terms of the image.
struct AxisChain {
    std::vector<AxisWeights> halvings, made_of;
};

AxisChain axis_chain(int size, MipKernel kernel, Wrap wrap) {
    AxisChain chain{{}, {identity(size)}};
    while (chain.made_of.back().size() > 1) {
        chain.halvings.push_back(halving(int(chain.made_of.back().size()), kernel, wrap));
        chain.made_of.push_back(composed(chain.halvings.back(), chain.made_of.back()));
    }
    return chain;
}

/// Image (i, j) is halved i times across and j times down; it stands at j * across + i.
struct RipmapRule {
    std::vector<LinearImage> images;
    std::size_t across = 0, down = 0;
    FilterOptions options;

    void operator()(const Footprint& f, auto&& read) const {
        const double u = lod_in_chain(std::log2(std::max(std::abs(f.per_x.x), std::abs(f.per_y.x))), options,
                                      across),
                     v = lod_in_chain(std::log2(std::max(std::abs(f.per_x.y), std::abs(f.per_y.y))), options,
                                      down);
        for (const auto& [j, row_weight] : around(v, down))
            for (const auto& [i, column_weight] : around(u, across))
                bilinear(i, j, {f.centre, row_weight * column_weight}, read);
    }
    struct Level {
        std::size_t index;
        double weight;
    };
    static std::array<Level, 2> around(double lod, std::size_t levels) {
        const double finer = std::floor(lod), share = lod - finer;
        const auto index = std::size_t(finer);
        return {Level{index, 1 - share}, Level{std::min(index + 1, levels - 1), share}};
    }
    struct Weighted {
        glm::dvec2 place;
        double weight;
    };
    void bilinear(std::size_t i, std::size_t j, const Weighted& where, auto&& read) const {
        const std::size_t index = j * across + i;
        const LinearImage &image = images[index], &finest = images[0];
        const glm::dvec2 scale{double(image.width) / finest.width, double(image.height) / finest.height};
        read_bilinear(image, options.addressing, where.place * scale,
                      Tap{.image = int(index), .weight = where.weight}, read);
    }
    glm::dvec4 value(const Tap& tap) const {
        return glm::dvec4{images[std::size_t(tap.image)].at(tap.column, tap.row)};
    }
};

Sampler prepare_ripmap(const LinearImage& image, const FilterOptions& options) {
    const AxisChain columns = axis_chain(image.width, options.mip_kernel, options.addressing.u),
                    rows = axis_chain(image.height, options.mip_kernel, options.addressing.v);
    RipmapRule rule{{}, columns.made_of.size(), rows.made_of.size(), options};
    std::vector<StoredImage> stored;
    for (std::size_t j = 0; j < rule.down; ++j)
        for (std::size_t i = 0; i < rule.across; ++i) {
            if (i > 0)
                rule.images.push_back(resampled(rule.images.back(), columns.halvings[i - 1],
                                                identity(rule.images.back().height)));
            else if (j > 0)
                rule.images.push_back(resampled(rule.images[(j - 1) * rule.across], identity(image.width),
                                                rows.halvings[j - 1]));
            else
                rule.images.push_back(image);
            stored.push_back(stored_image(columns.made_of[i], rows.made_of[j]));
        }
    return sampler(std::move(rule), std::move(stored));
}

}  // namespace

std::vector<Method> ripmap_methods() {
    return {
        {.name = "ripmap",
         .card = {.footprint =
                      "The box around the two steps: max(|du/dx|, |du/dy|) by max(|dv/dx|, |dv/dy|).",
                  .lod = "One for either axis: log2 of that side in texels; each is biased and clamped by "
                         "itself.",
                  .taps = "Bilinear in the four images around the pair of LODs, weighted by the product of "
                          "their fractions.",
                  .source = "McReynolds and Blythe 1999, course notes (attribution from memory)"},
         .prepare = prepare_ripmap}};
}

}  // namespace zproof::texture
