#include "texture/methods/families.h"
#include "texture/methods/tap_rule.h"

namespace zproof::texture {

namespace {

/// Level 0 alone, read by Kind.
enum class Kind { nearest, bilinear };

template <Kind kind>
struct PointRule {
    LinearImage image;
    Addressing wrap;

    void operator()(const Footprint& footprint, auto&& read) const {
        const Tap whole{.image = 0, .weight = 1};
        if constexpr (kind == Kind::nearest)
            read_nearest(image, wrap, footprint.centre, whole, read);
        else
            read_bilinear(image, wrap, footprint.centre, whole, read);
    }
    glm::dvec4 value(const Tap& tap) const { return glm::dvec4{image.at(tap.column, tap.row)}; }
};

template <Kind kind>
Sampler prepare(const LinearImage& image, const FilterOptions& options) {
    const StoredImage level{image.width, image.height, sizeof(glm::vec4), [](int column, int row) {
                                return std::vector<Share>{{column, row, 1}};
                            }};
    return sampler(PointRule<kind>{image, options.addressing}, {level});
}

}  // namespace

std::vector<Method> point_methods() {
    return {{.name = "nearest",
             .card = {.footprint = "The pixel's centre.",
                      .lod = "Level 0.",
                      .taps = "The texel that holds the place.",
                      .source = "OpenGL 4.6 core, 8.14.3"},
             .prepare = prepare<Kind::nearest>},
            {.name = "bilinear",
             .card = {.footprint = "The pixel's centre.",
                      .lod = "Level 0.",
                      .taps = "The four texels whose centres surround the place, weighted by product.",
                      .source = "OpenGL 4.6 core, 8.14.3"},
             .prepare = prepare<Kind::bilinear>}};
}

}  // namespace zproof::texture
