#include <algorithm>
#include <cmath>
#include <memory>

#include "filters/methods/families.h"
#include "filters/stored/summed_area.h"

namespace zproof::texture {

namespace {

/// A box of the texture, in texels.
struct Box {
    glm::dvec2 low{0}, high{0};
};

/// The box is at least one texel wide and high: a smaller one would show the texels of a magnified texture as
/// squares.
Box box_around(const glm::dvec2& centre, const glm::dvec2& size) {
    const glm::dvec2 half = glm::max(size, 1.0) / 2.0;
    return {centre - half, centre + half};
}

glm::dvec2 affine_size(const Footprint& f) { return glm::abs(f.per_x) + glm::abs(f.per_y); }

Box affine(const Footprint& f) { return box_around(f.centre, affine_size(f)); }

Box largest(const Footprint& f) {
    return box_around(f.centre, glm::max(glm::abs(f.per_x), glm::abs(f.per_y)));
}

Box moment(const Footprint& f) {
    return box_around(f.centre, glm::sqrt(f.per_x * f.per_x + f.per_y * f.per_y));
}

/// The box that holds the parallelogram, shrunk to its area.
Box equal_area(const Footprint& f) {
    const glm::dvec2 size = affine_size(f);
    const double area = std::abs(f.per_x.x * f.per_y.y - f.per_x.y * f.per_y.x), around = size.x * size.y;
    return box_around(f.centre, around > 0 ? size * std::sqrt(area / around) : size);
}

/// What a rectangle of the image, between two corners of it, shows of the texture.
Box bounds_of(const Footprint& f, const glm::dvec2& from_raster, const glm::dvec2& to_raster) {
    const glm::dvec2 a = f.at(from_raster), b = f.at({to_raster.x, from_raster.y}), c = f.at(to_raster),
                     d = f.at({from_raster.x, to_raster.y});
    const glm::dvec2 low = glm::min(glm::min(a, b), glm::min(c, d)),
                     high = glm::max(glm::max(a, b), glm::max(c, d));
    return box_around((low + high) / 2.0, high - low);
}

/// Whether the pixel lies wholly before the plane's horizon; its quad has no bounds otherwise.
bool is_before_horizon(const Footprint& f) {
    const auto& w = f.texels_from_raster.w;
    return w.at(f.centre_raster.x, f.centre_raster.y) > (std::abs(w.a) + std::abs(w.b)) / 2;
}

/// The pixel cut into across x down equal rectangles, each with the same weight.
void cut(const Footprint& f, glm::ivec2 pieces, auto&& visit) {
    if (!is_before_horizon(f)) return visit(affine(f), 1.0);
    const glm::dvec2 corner = f.centre_raster - 0.5, step = 1.0 / glm::dvec2(pieces);
    for (int down = 0; down < pieces.y; ++down)
        for (int across = 0; across < pieces.x; ++across)
            visit(bounds_of(f, corner + step * glm::dvec2(across, down),
                            corner + step * glm::dvec2(across + 1, down + 1)),
                  step.x * step.y);
}

/// Takes as many strips as the ellipse's axes differ, across the longer of the pixel's two steps.
glm::ivec2 strips(const Footprint& f, int limit) {
    const Ellipse axes = ellipse(f);
    const double ratio = axes.minor > 0 ? axes.major / axes.minor : limit;
    const int count = int(std::clamp(std::ceil(ratio), 1.0, double(limit)));
    return glm::length(f.per_x) >= glm::length(f.per_y) ? glm::ivec2{count, 1} : glm::ivec2{1, count};
}

/// Which boxes a footprint is made of.
enum class Shape { affine, quad, largest, equal_area, moment, subquads, strips };

template <Shape shape>
void each_box(const Footprint& f, const FilterOptions& options, auto&& visit) {
    if constexpr (shape == Shape::affine) visit(affine(f), 1.0);
    if constexpr (shape == Shape::quad) cut(f, {1, 1}, visit);
    if constexpr (shape == Shape::largest) visit(largest(f), 1.0);
    if constexpr (shape == Shape::equal_area) visit(equal_area(f), 1.0);
    if constexpr (shape == Shape::moment) visit(moment(f), 1.0);
    if constexpr (shape == Shape::subquads) cut(f, glm::ivec2{options.subdivisions}, visit);
    if constexpr (shape == Shape::strips) cut(f, strips(f, options.max_anisotropy), visit);
}

template <Shape shape>
struct SatRule {
    SummedArea table;
    FilterOptions options;

    glm::dvec4 colour(const Footprint& footprint) const {
        glm::dvec4 sum{0};
        each_box<shape>(footprint, options, [&](const Box& box, double weight) {
            sum +=
                weight * table.mean(covered({box.low.x, box.high.x}, options.addressing.u, table.width()),
                                    covered({box.low.y, box.high.y}, options.addressing.v, table.height()));
        });
        return sum;
    }
    std::vector<Tap> taps(const Footprint& footprint) const {
        std::vector<Tap> taps;
        each_box<shape>(footprint, options, [&](const Box& box, double weight) {
            const auto columns = prefixes({box.low.x, box.high.x}, options.addressing.u, table.width()),
                       rows = prefixes({box.low.y, box.high.y}, options.addressing.v, table.height());
            for (const Prefix& down : rows.all())
                for (const Prefix& across : columns.all())
                    taps.push_back(
                        {0, across.count - 1, down.count - 1, weight * across.weight * down.weight});
        });
        return taps;
    }
};

template <Shape shape>
Sampler prepare_sat(const LinearImage& image, const FilterOptions& options) {
    const auto rule = std::make_shared<const SatRule<shape>>(
        SatRule<shape>{SummedArea(image, options.sat_storage), options});
    const StoredImage sums{image.width, image.height, rule->table.bytes_per_texel(), [](int column, int row) {
                               return std::vector<Share>{{0, 0, 1, column + 1, row + 1}};
                           }};
    return {.colour = [rule](const Footprint& footprint) { return rule->colour(footprint); },
            .taps = [rule](const Footprint& footprint) { return rule->taps(footprint); },
            .stored = {sums}};
}

Method described(Shape shape, std::string name, std::string footprint, std::string source) {
    const bool is_many = shape == Shape::subquads || shape == Shape::strips;
    return {
        .name = std::move(name),
        .card = {.footprint = std::move(footprint),
                 .lod = "None: sums of level 0.",
                 .taps = (is_many ? std::string("The mean of the boxes' means, each")
                                  : std::string("The box's mean,")) +
                         " from sums over the whole texture at four corners, each interpolated between four "
                         "stored sums. A box is at least one texel wide and high.",
                 .source = std::move(source)},
        .prepare = {}};
}

template <Shape shape>
Method method(std::string name, std::string footprint, std::string source) {
    Method made = described(shape, std::move(name), std::move(footprint), std::move(source));
    made.prepare = prepare_sat<shape>;
    return made;
}

}  // namespace

std::vector<Method> sat_methods() {
    const std::string horizon = " Where the pixel meets the plane's horizon: as sat-affine.";
    return {
        method<Shape::affine>(
            "sat-affine",
            "The upright box round the pixel's parallelogram: |du/dx| + |du/dy| by |dv/dx| + |dv/dy|.",
            "Crow 1984"),
        method<Shape::quad>(
            "sat-quad",
            "The upright box round the quadrilateral that the pixel's four corners make on the texture." +
                horizon,
            "Crow 1984"),
        method<Shape::largest>(
            "sat-largest",
            "The upright box of max(|du/dx|, |du/dy|) by max(|dv/dx|, |dv/dy|), about the pixel's centre.",
            "ours"),
        method<Shape::equal_area>(
            "sat-area", "The box of sat-affine, shrunk about its centre to the parallelogram's area.",
            "Ohio State University, CSE 782, laboratory notes"),
        method<Shape::moment>("sat-moment",
                              "The upright box of hypot(du/dx, du/dy) by hypot(dv/dx, dv/dy): it has the "
                              "parallelogram's variance along both axes.",
                              "ours"),
        method<Shape::subquads>("sat-subquads",
                                "The pixel cut into n x n squares; round each square's quadrilateral on the "
                                "texture its upright box." +
                                    horizon,
                                "ours"),
        method<Shape::strips>(
            "sat-strips",
            "The pixel cut across the longer of its two steps into strips: the ratio of the "
            "ellipse's major axis to its minor one, rounded up, at most the largest "
            "anisotropy. Round each strip's quadrilateral its upright box." +
                horizon,
            "ours")};
}

}  // namespace zproof::texture
