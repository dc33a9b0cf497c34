#include "cli/selftest/spot.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "compare/bounds/triangle_depth.h"

namespace zproof::selftest {
namespace {

constexpr int clearance = 3;  // pixels on each side: more than any eps

bool is_clear(const Stage& stage, Pixel p) {
    const PrimitiveId id = stage.good.primitive.at(p.x, p.y);
    for (int y = p.y - clearance; y <= p.y + clearance; ++y)
        for (int x = p.x - clearance; x <= p.x + clearance; ++x)
            if (stage.good.primitive.at(x, y) != id || stage.reference.primitive.at(x, y) != id) return false;
    return true;
}

template <class Wanted>
Pixel first_clear_pixel(const Stage& stage, Wanted wanted) {
    const int width = stage.view.width, height = stage.view.height;
    const int rows = height - 2 * clearance, columns = width - 2 * clearance;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Pixel p{clearance + column, clearance + (row + rows / 2) % rows};
            if (wanted(stage.good.primitive.at(p.x, p.y)) && is_clear(stage, p)) return p;
        }
    throw std::logic_error("selftest: no pixel of " + stage.view.name + " has the surroundings it needs");
}

}  // namespace

Pixel amid_a_triangle(const Stage& stage) { return amid_another_triangle(stage, PrimitiveId::none); }

Pixel amid_background(const Stage& stage) {
    return first_clear_pixel(stage, [](PrimitiveId id) { return id == PrimitiveId::none; });
}

Pixel amid_another_triangle(const Stage& stage, PrimitiveId first) {
    return first_clear_pixel(stage, [&](PrimitiveId id) { return id != PrimitiveId::none && id != first; });
}

DepthBound lawful_depths(const Stage& stage, Pixel pixel) {
    const ViewBounds bounds(stage.view, stage.precision);
    const auto id = std::uint32_t(stage.good.primitive.at(pixel.x, pixel.y));
    const TriangleInView triangle(stage.view, bounds, corners_of(stage.scene, id));
    return TriangleDepth(triangle, bounds).at(pixel.x, pixel.y);
}

CommonestIds commonest_ids(const Frame& frame) {
    std::map<PrimitiveId, std::size_t> pixels;
    for (const PrimitiveId id : frame.primitive.pixels())
        if (id != PrimitiveId::none) ++pixels[id];
    const auto commonest = [&] {
        const auto most =
            std::ranges::max_element(pixels, {}, [](const auto& entry) { return entry.second; });
        return most == pixels.end() ? PrimitiveId::none : most->first;
    };
    CommonestIds ids{.first = commonest()};
    pixels.erase(ids.first);
    ids.second = commonest();
    return ids;
}

}  // namespace zproof::selftest
