#include "reports/view_picture.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "reports/class_colour.h"
#include "reports/pictures.h"

namespace zproof {

namespace {

/// A ring around a mark, pixels of the picture from its centre. Defects have the broader one.
struct Ring {
    double inner = 4, outer;
};
constexpr Ring admissible_ring{.outer = 5}, defect_ring{.outer = 6};

/// The middle of a part of a pixel of the picture, in pixels of the view.
int middle_of(int pixel, int part, int parts, int view_side, int picture_side) {
    return int((pixel + (part + 0.5) / parts) * view_side / picture_side);
}

/// What is drawn: the view's frame, and the light of its pixels.
struct Seen {
    const Plane<PrimitiveId>& ids;
    const ColourAt& colour_at;
};

/// The mean of the parts of a pixel of the picture; parts of one triangle are shaded once.
LinearRgb mean_at(const Seen& seen, int x, int y, Resolution picture, int side) {
    const Resolution view = seen.ids.size();
    LinearRgb sum{}, light{};
    PrimitiveId last = PrimitiveId::none;
    const auto share = 1 / float(side * side);
    for (int part = 0; part < side * side; ++part) {
        const int x_view = middle_of(x, part % side, side, view.width, picture.width),
                  y_view = middle_of(y, part / side, side, view.height, picture.height);
        const PrimitiveId id = seen.ids.at(x_view, y_view);
        if (part == 0 || id != last) light = seen.colour_at(x_view, y_view);
        last = id;
        sum = {sum.r + share * light.r, sum.g + share * light.g, sum.b + share * light.b};
    }
    return sum;
}

Plane<Rgb8> drawn(const Seen& seen, Resolution resolution, int samples_per_side) {
    Picture light(resolution);
    tbb::parallel_for(0, resolution.height, [&](int y) {
        for (int x = 0; x < resolution.width; ++x)
            light.at(x, y) = mean_at(seen, x, y, resolution, samples_per_side);
    });
    return picture_of_light(light);
}

/// Each pixel as a square of whole pixels.
Plane<Rgb8> enlarged(const Plane<Rgb8>& small, Resolution resolution) {
    const int times = resolution.width / small.size().width;
    Plane<Rgb8> large(resolution);
    for (int y = 0; y < resolution.height; ++y)
        for (int x = 0; x < resolution.width; ++x) large.at(x, y) = small.at(x / times, y / times);
    return large;
}

/// The severest class of the view's pixels that each pixel of the picture holds.
Plane<PixelClass> marks_of(const Plane<PixelClass>& classes, Resolution picture) {
    Plane<PixelClass> marks(picture, PixelClass::agree);
    const Resolution view = classes.size();
    for (int y = 0; y < view.height; ++y) {
        const std::span<const PixelClass> row = classes.row(y);
        for (int x = 0; x < view.width; ++x)
            if (row[std::size_t(x)] != PixelClass::agree) {
                PixelClass& mark = marks.at(x * picture.width / view.width, y * picture.height / view.height);
                mark = std::max(mark, row[std::size_t(x)]);
            }
    }
    return marks;
}

/// Calls visit(x, y, squared distance) for the pixels of the picture that lie within the radius.
template <class Visit>
void for_each_near(int x, int y, double radius, Resolution size, Visit visit) {
    const int reach = int(radius);
    for (int j = std::max(0, y - reach); j <= std::min(size.height - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(size.width - 1, x + reach); ++i)
            if (const int square = (i - x) * (i - x) + (j - y) * (j - y); square <= radius * radius)
                visit(i, j, square);
}

/// The class that is seen at each pixel, of rings and of what they enclose.
struct Outline {
    Plane<PixelClass> ring;
    Plane<std::uint8_t> enclosed;

    Outline(const Plane<PixelClass>& marks, Ring shape, bool admissible)
        : ring(marks.size(), PixelClass::agree), enclosed(marks.size()) {
        for (int y = 0; y < marks.size().height; ++y)
            for (int x = 0; x < marks.size().width; ++x)
                if (const PixelClass c = marks.at(x, y); c != PixelClass::agree && passes(c) == admissible)
                    for_each_near(x, y, shape.outer, marks.size(), [&](int i, int j, int square) {
                        ring.at(i, j) = std::max(ring.at(i, j), c);
                        if (square <= shape.inner * shape.inner) enclosed.at(i, j) = 1;
                    });
    }
};

void draw(const Outline& outline, Plane<Rgb8>& picture) {
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        if (const PixelClass c = outline.ring.pixels()[i];
            c != PixelClass::agree && outline.enclosed.pixels()[i] == 0)
            picture.pixels()[i] = colour_of(c);
}

void draw_defects(const Plane<PixelClass>& marks, Plane<Rgb8>& picture) {
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        if (const PixelClass c = marks.pixels()[i]; !passes(c)) picture.pixels()[i] = colour_of(c);
}

}  // namespace

Resolution resolution_of(PictureSize size, Resolution view) {
    const int longest = std::max(view.width, view.height);
    if (const int enlarged = size.longest_side / longest; enlarged >= 1)
        return {view.width * enlarged, view.height * enlarged};
    const auto shrunk = [&](int length) { return std::max(1, length * size.longest_side / longest); };
    return {shrunk(view.width), shrunk(view.height)};
}

Plane<Rgb8> view_picture(const Plane<PixelClass>& classes, const Plane<PrimitiveId>& ids,
                         const ColourAt& colour_at, PictureSize size) {
    const Resolution view = classes.size(), resolution = resolution_of(size, view);
    Plane<Rgb8> picture = resolution.width > view.width
                              ? enlarged(drawn({ids, colour_at}, view, 1), resolution)
                              : drawn({ids, colour_at}, resolution, size.samples_per_side);
    const Plane<PixelClass> marks = marks_of(classes, resolution);
    draw(Outline(marks, admissible_ring, true), picture);
    draw_defects(marks, picture);
    draw(Outline(marks, defect_ring, false), picture);
    return picture;
}

}  // namespace zproof
