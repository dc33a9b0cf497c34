#include <array>

#include "measure/selfcheck/frame_mapping.h"
#include "measure/selfcheck/variants.h"
#include "scenes/pixel_lattice.h"

namespace zproof::measure {
namespace {

constexpr int largest_side_px = 16384;  // as in a view file

Frame as_rendered(const Frame& frame) { return frame; }

PrimitiveId same_id(PrimitiveId id, Pixel) { return id; }

/// A part of a picture: its upper left pixel and its size.
struct Crop {
    int x = 0, y = 0;
    Resolution size;
};

View cropped(const View& view, const Crop& crop) {
    View part = view;
    const Window& w = view.camera.window;
    const double pixel_x = (w.right - w.left) / view.width, pixel_y = (w.top - w.bottom) / view.height;
    part.width = crop.size.width;
    part.height = crop.size.height;
    part.camera.window = {.left = w.left + pixel_x * crop.x,
                          .right = w.left + pixel_x * (crop.x + crop.size.width),
                          .bottom = w.top - pixel_y * (crop.y + crop.size.height),
                          .top = w.top - pixel_y * crop.y};
    return part;
}

VariantPicture picture_of(const View& view, const Crop& crop) {
    const View part = cropped(view, crop);
    const auto expected = [crop](const Frame& original) {
        return mapped_frame(
            original, crop.size,
            [crop](int x, int y) {
                return Pixel{crop.x + x, crop.y + y};
            },
            same_id);
    };
    return {part, part, as_rendered, expected};
}

}  // namespace

Scene same_scene(const Scene& scene) { return scene; }

std::vector<VariantPicture> moved_by_whole_pixels(const Scene&, const View& view) {
    constexpr int columns = 7, rows = 5;
    if (view.width <= columns || view.height <= rows) return {};
    return {picture_of(view, {columns, rows, {view.width - columns, view.height - rows}})};
}

std::vector<VariantPicture> cut_into_tiles(const Scene&, const View& view) {
    if (view.width < 2 || view.height < 2) return {};
    const int x = view.width / 2, y = view.height / 2;
    std::vector<VariantPicture> tiles;
    for (const Crop& crop : {Crop{0, 0, {x, y}}, Crop{x, 0, {view.width - x, y}},
                             Crop{0, y, {x, view.height - y}}, Crop{x, y, {view.width - x, view.height - y}}})
        tiles.push_back(picture_of(view, crop));
    return tiles;
}

std::vector<VariantPicture> three_times_as_large(const Scene&, const View& view) {
    if (view.width > largest_side_px / 3 || view.height > largest_side_px / 3) return {};
    View large = view;
    large.width *= 3;
    large.height *= 3;
    const auto middle_ones = [](const Frame& rendered) {
        return frame_at({.stride = 3, .first_x = 1, .first_y = 1}, rendered);
    };
    return {{large, view, middle_ones, as_rendered}};
}

}  // namespace zproof::measure
