#include "texture/methods/families.h"
#include "texture/methods/tap_rule.h"

namespace zproof::texture {

namespace {

/// How level 0, the only one, is read.
enum class PointRead { nearest, bilinear, bicubic };

/// Catmull-Rom at distance x from a texel's centre, |x| < 2: Keys 1981 with a = -1/2.
double catmull_rom(double x) {
    const double d = std::abs(x);
    return d < 1 ? 1 + d * d * (1.5 * d - 2.5) : 2 + d * (-4 + d * (2.5 - d / 2));
}

/// The sixteen texels whose centres are nearest, weighted by product.
void read_bicubic(const LinearImage& image, const Addressing& wrap, const glm::dvec2& place, Tap tap,
                  auto&& read) {
    const glm::dvec2 between{place_on_line(place.x) - 0.5, place_on_line(place.y) - 0.5},
        low = glm::floor(between);
    for (int down = -1; down <= 2; ++down)
        for (int right = -1; right <= 2; ++right)
            read(Tap{
                tap.image, wrapped(wrap.u, std::int64_t(low.x) + right, image.width),
                wrapped(wrap.v, std::int64_t(low.y) + down, image.height),
                tap.weight * catmull_rom(low.x + right - between.x) * catmull_rom(low.y + down - between.y)});
}

template <PointRead kind>
struct PointRule {
    LinearImage image;
    Addressing wrap;

    void operator()(const Footprint& footprint, auto&& read) const {
        const Tap whole{.image = 0, .weight = 1};
        if constexpr (kind == PointRead::nearest)
            read_nearest(image, wrap, footprint.centre, whole, read);
        else if constexpr (kind == PointRead::bilinear)
            read_bilinear(image, wrap, footprint.centre, whole, read);
        else
            read_bicubic(image, wrap, footprint.centre, whole, read);
    }
    glm::dvec4 value(const Tap& tap) const { return glm::dvec4{image.at(tap.column, tap.row)}; }
};

template <PointRead kind>
Sampler prepare_point(const LinearImage& image, const FilterOptions& options) {
    return sampler(PointRule<kind>{image, options.addressing}, {level_zero(image)});
}

}  // namespace

std::vector<Method> point_methods() {
    return {
        {.name = "nearest",
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
         .prepare = prepare_point<PointRead::bilinear>},
        {.name = "bicubic",
         .card = {.footprint = "The pixel's centre.",
                  .lod = "Level 0.",
                  .taps =
                      "The sixteen texels around the place, weighted by the product of two Catmull-Rom "
                      "cubics (a = -1/2). Weights may be negative: the result may leave the texels' range.",
                  .source = "Keys 1981; Catmull and Rom 1974"},
         .prepare = prepare_point<PointRead::bicubic>}};
}

}  // namespace zproof::texture
