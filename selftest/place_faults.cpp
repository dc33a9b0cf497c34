#include <algorithm>
#include <optional>

#include "selftest/catalogue.h"
#include "selftest/fault_pixel.h"

namespace zproof::selftest {
namespace {

constexpr int tile_size = 16;

/// Where a pixel of the faulty frame takes its answer from; nothing: background.
using Source = std::function<std::optional<Pixel>(const Fixture&, Pixel)>;

/// Pixels [x0, x1) x [y0, y1).
struct Area {
    int x0, y0, x1, y1;
};

Area whole(const Fixture& fixture) { return {0, 0, fixture.view.width, fixture.view.height}; }

Frame redrawn(const Fixture& fixture, const Area& area, const Source& source) {
    Frame frame = fixture.good;
    for (int y = area.y0; y < area.y1; ++y)
        for (int x = area.x0; x < area.x1; ++x) {
            const auto from = source(fixture, {x, y});
            frame.primitive.at(x, y) = from ? fixture.good.primitive.at(from->x, from->y) : PrimitiveId::none;
            frame.camera_depth.at(x, y) =
                from ? fixture.good.camera_depth.at(from->x, from->y) : background_depth;
        }
    return frame;
}

std::function<Frame(const Fixture&)> taken_from(const Source& source,
                                                const std::function<Area(const Fixture&)>& area_of = whole) {
    return [=](const Fixture& fixture) { return redrawn(fixture, area_of(fixture), source); };
}

std::optional<Pixel> if_inside(const Fixture& fixture, Pixel p) {
    if (p.x < 0 || p.y < 0 || p.x >= fixture.view.width || p.y >= fixture.view.height) return std::nullopt;
    return p;
}

Source moved_by(int dx, int dy) {
    return [=](const Fixture& fixture, Pixel p) { return if_inside(fixture, {p.x - dx, p.y - dy}); };
}

std::optional<Pixel> nowhere(const Fixture&, Pixel) { return std::nullopt; }

Area row_of_the_pixel(const Fixture& fixture) {
    const Pixel fault_pixel = amid_a_triangle(fixture);
    return {0, fault_pixel.y, fixture.view.width, fault_pixel.y + 1};
}

Area column_of_the_pixel(const Fixture& fixture) {
    const Pixel fault_pixel = amid_a_triangle(fixture);
    return {fault_pixel.x, 0, fault_pixel.x + 1, fixture.view.height};
}

/// The tile that holds the fault pixel, cut to the image.
Area tile_of_the_pixel(const Fixture& fixture) {
    const Pixel fault_pixel = amid_a_triangle(fixture);
    const int x0 = fault_pixel.x / tile_size * tile_size, y0 = fault_pixel.y / tile_size * tile_size;
    return {x0, y0, std::min(x0 + tile_size, fixture.view.width),
            std::min(y0 + tile_size, fixture.view.height)};
}

Pixel mirrored_x(const Fixture& fixture, Pixel p) { return {fixture.view.width - 1 - p.x, p.y}; }
Pixel flipped_y(const Fixture& fixture, Pixel p) { return {p.x, fixture.view.height - 1 - p.y}; }
Pixel turned(const Fixture& fixture, Pixel p) { return mirrored_x(fixture, flipped_y(fixture, p)); }
/// Rows become columns, stretched to the image's shape.
Pixel transposed(const Fixture& fixture, Pixel p) {
    return {p.y * fixture.view.width / fixture.view.height, p.x * fixture.view.height / fixture.view.width};
}

Frame of_another_size(const Fixture& fixture) { return Frame({fixture.view.width - 1, fixture.view.height}); }

std::vector<Fault> faults_of_an_area() {
    const Expected outside{.classes = {PixelClass::outside}, .count = {}};
    const Expected hole{.classes = {PixelClass::hole}, .count = {}};
    return {
        {"row_moved", "one row lies one pixel to the right", outside,
         taken_from(moved_by(1, 0), row_of_the_pixel)},
        {"row_lost", "one row is background", hole, taken_from(nowhere, row_of_the_pixel)},
        {"column_lost", "one column is background", hole, taken_from(nowhere, column_of_the_pixel)},
        {"tile_missing", "a tile of 16 x 16 pixels was not drawn", hole,
         taken_from(nowhere, tile_of_the_pixel)},
        {"tile_of_the_neighbour", "a tile of 16 x 16 pixels shows the one to its left", outside,
         taken_from(moved_by(tile_size, 0), tile_of_the_pixel)},
        {"rows_doubled", "every other row is a copy of the one above", outside,
         taken_from([](const Fixture&, Pixel p) {
             return Pixel{p.x, p.y & ~1};
         })},
    };
}

}  // namespace

std::vector<Fault> faults_of_place() {
    const Expected outside{.classes = {PixelClass::outside}, .count = {}};
    std::vector<Fault> all = faults_of_an_area();
    const std::vector<Fault> whole{
        {"shifted_right", "the picture lies one pixel too far right", outside, taken_from(moved_by(1, 0))},
        {"shifted_left", "the picture lies one pixel too far left", outside, taken_from(moved_by(-1, 0))},
        {"shifted_down", "the picture lies one pixel too low", outside, taken_from(moved_by(0, 1))},
        {"shifted_up", "the picture lies one pixel too high", outside, taken_from(moved_by(0, -1))},
        {"flipped_y", "the picture is upside down", outside, taken_from(flipped_y)},
        {"mirrored_x", "left and right are exchanged", outside, taken_from(mirrored_x)},
        {"turned", "the picture is turned by 180 degrees", outside, taken_from(turned)},
        {"transposed", "rows and columns are exchanged", outside, taken_from(transposed)},
        {"all_background",
         "nothing was drawn",
         {.classes = {PixelClass::hole}, .count = {}},
         taken_from(nowhere)},
        {"another_size",
         "the frame is one column short",
         {.answer = Expected::Answer::refuse, .classes = {}, .count = {}},
         of_another_size},
    };
    all.insert(all.end(), whole.begin(), whole.end());
    return all;
}

}  // namespace zproof::selftest
