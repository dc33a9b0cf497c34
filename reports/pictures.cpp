#include "reports/pictures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "math/srgb.h"
#include "reports/class_colour.h"
#include "reports/depth_colours.h"
#include "reports/id_colours.h"
#include "reports/viridis.h"

namespace zproof {

namespace {

constexpr int undotted_side = 240;  // pages show pictures at least this wide

/// Equal neighbours are looked up once.
template <class T, class Colour>
Plane<Rgb8> coloured(const Plane<T>& values, Colour colour) {
    auto picture = Plane<Rgb8>::unwritten(values.size());
    tbb::parallel_for(0, values.size().height, [&](int y) {
        const std::span<const T> row = values.row(y);
        const std::span<Rgb8> to = picture.row(y);
        for (std::size_t x = 0; x < row.size(); ++x)
            to[x] = x > 0 && row[x] == row[x - 1] ? to[x - 1] : colour(row[x]);
    });
    return picture;
}

std::uint8_t srgb(float linear) { return channel(encoded_srgb(linear)); }

Rgb8 colour_of_light(const LinearRgb& c) {
    if (std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b)) return no_depth_colour;
    return {srgb(c.r), srgb(c.g), srgb(c.b)};
}

/// Has no branch, so that neighbours are compared side by side.
PixelClass severer_of(PixelClass a, PixelClass b) { return a > b ? a : b; }

template <class Visit>
void for_each_pixel(Resolution size, Visit visit) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) visit(x, y);
}

}  // namespace

Plane<Rgb8> picture_of_ids(const Plane<PrimitiveId>& ids) {
    auto picture = Plane<Rgb8>::unwritten(ids.size());
    tbb::parallel_for(0, ids.size().height, [&](int y) { colour_ids(ids.row(y), picture.row(y)); });
    return picture;
}

Plane<Rgb8> picture_of_depths(const Plane<float>& depths) {
    const DepthColours colours(range_of(depths));
    auto picture = Plane<Rgb8>::unwritten(depths.size());
    tbb::parallel_for(0, depths.size().height, [&](int y) { colours.colour(depths.row(y), picture.row(y)); });
    return picture;
}

Plane<Rgb8> picture_of_light(const Picture& picture) { return coloured(picture, colour_of_light); }

Plane<Rgb8> picture_of_difference(const Picture& a, const Picture& b) {
    Plane<Rgb8> picture(a.size());
    std::ranges::transform(
        a.pixels(), b.pixels(), picture.pixels().begin(), [](const LinearRgb& p, const LinearRgb& q) {
            const double d = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
            return std::isnan(d) ? no_depth_colour : d == 0 ? background_colour : viridis(std::sqrt(d));
        });
    return picture;
}

Plane<Rgb8> picture_of_classes(const Plane<PixelClass>& classes) { return coloured(classes, colour_of); }

int shrink_factor(Resolution size) {
    return std::max(1, (std::max(size.width, size.height) + small_side - 1) / small_side);
}

Resolution shrunk(Resolution size, int factor) {
    return {(size.width + factor - 1) / factor, (size.height + factor - 1) / factor};
}

Plane<PixelClass> pooled_by_severity(const Plane<PixelClass>& classes, int factor) {
    Plane<PixelClass> small(shrunk(classes.size(), factor), PixelClass::agree);
    std::vector<PixelClass> severest(std::size_t(classes.size().width));  // of each column of a row of blocks
    for (int y = 0; y < classes.size().height; ++y) {
        const std::span<const PixelClass> row = classes.row(y);
        const bool begins = y % factor == 0,
                   ends = y % factor == factor - 1 || y == classes.size().height - 1;
        if (begins) std::ranges::copy(row, severest.begin());
        for (std::size_t x = 0; !begins && x < row.size(); ++x) severest[x] = severer_of(severest[x], row[x]);
        const std::span<PixelClass> blocks = small.row(y / factor);
        for (std::size_t x = 0; ends && x < row.size(); x += std::size_t(factor))
            blocks[x / std::size_t(factor)] = std::ranges::max(
                std::span(severest).subspan(x, std::min(std::size_t(factor), row.size() - x)));
    }
    return small;
}

Plane<PixelClass> with_dots(const Plane<PixelClass>& classes) {
    Plane<PixelClass> dotted = classes;
    const Resolution size = classes.size();
    for_each_pixel(size, [&](int x, int y) {
        const PixelClass c = classes.at(x, y);
        if (passes(c)) return;
        for (int j = std::max(0, y - 1); j <= std::min(size.height - 1, y + 1); ++j)
            for (int i = std::max(0, x - 1); i <= std::min(size.width - 1, x + 1); ++i)
                dotted.at(i, j) = std::max(dotted.at(i, j), c);
    });
    return dotted;
}

bool has_dots(Resolution view) {
    const Resolution small = shrunk(view, shrink_factor(view));
    return std::max(small.width, small.height) > undotted_side;
}

Plane<PixelClass> small_class_map(const Plane<PixelClass>& classes) {
    const Plane<PixelClass> small = pooled_by_severity(classes, shrink_factor(classes.size()));
    return has_dots(classes.size()) ? with_dots(small) : small;
}

}  // namespace zproof