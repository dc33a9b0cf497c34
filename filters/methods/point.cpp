#include "filters/methods/families.h"
#include "filters/methods/tap_rule.h"

namespace zproof::texture {

namespace {

/// How level 0, the only one, is read.
enum class PointRead { nearest, bilinear };

template <PointRead kind>
struct PointRule {
    LinearImage image;
    Addressing wrap;

    void operator()(const Footprint& footprint, auto&& read) const {
        const Tap whole{.image = 0, .weight = 1};
        if constexpr (kind == PointRead::nearest)
            read_nearest(image, wrap, footprint.centre, whole, read);
        else
            read_bilinear(image, wrap, footprint.centre, whole, read);
    }
    glm::dvec4 value(const Tap& tap) const { return glm::dvec4{image.at(tap.column, tap.row)}; }
};

template <PointRead kind>
Sampler prepare_point(const LinearImage& image, const FilterOptions& options) {
    return sampler(PointRule<kind>{image, options.addressing}, {level_zero(image)});
}

}  // namespace

std::vector<Method> point_methods() {
    return {{.name = "nearest",
             .card = {.footprint = "The pixel's centre.",
                      .lod = "Level 0.",
                      .taps = "The texel that holds the place.",
                      .source = "OpenGL 4.6 core, 8.14.3"},
             .prepare = prepare_point<PointRead::nearest>},
            {.name = "bilinear",
             .card = {.footprint = "The pixel's centre.",
                      .lod = "Level 0.",
                      .taps = "The four texels whose centres surround the place, weighted by product.",
                      .source = "OpenGL 4.6 core, 8.14.3"},
             .prepare = prepare_point<PointRead::bilinear>}};
}

}  // namespace zproof::texture
