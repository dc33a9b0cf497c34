#include "selftest/fault_pixel.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "compare/bounds/triangle_depth.h"

namespace zproof::selftest {
namespace {

constexpr int clearance = 3;  // pixels on each side: more than any eps

bool is_clear(const Fixture& fixture, Pixel p) {
    const PrimitiveId id = fixture.good.primitive.at(p.x, p.y);
    for (int y = p.y - clearance; y <= p.y + clearance; ++y)
        for (int x = p.x - clearance; x <= p.x + clearance; ++x)
            if (fixture.good.primitive.at(x, y) != id || fixture.reference.primitive.at(x, y) != id)
                return false;
    return true;
}

template <class Wanted>
Pixel first_clear_pixel(const Fixture& fixture, Wanted wanted) {
    const int width = fixture.view.width, height = fixture.view.height;
    const int rows = height - 2 * clearance, columns = width - 2 * clearance;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Pixel p{clearance + column, clearance + (row + rows / 2) % rows};
            if (wanted(fixture.good.primitive.at(p.x, p.y)) && is_clear(fixture, p)) return p;
        }
    throw std::logic_error("selftest: no pixel of " + fixture.view.name + " has the surroundings it needs");
}

}  // namespace

Pixel amid_a_triangle(const Fixture& fixture) { return amid_another_triangle(fixture, PrimitiveId::none); }

Pixel amid_background(const Fixture& fixture) {
    return first_clear_pixel(fixture, [](PrimitiveId id) { return id == PrimitiveId::none; });
}

Pixel amid_another_triangle(const Fixture& fixture, PrimitiveId first) {
    return first_clear_pixel(fixture, [&](PrimitiveId id) { return id != PrimitiveId::none && id != first; });
}

DepthBound admissible_depths(const Fixture& fixture, Pixel pixel) {
    const ViewBounds bounds(fixture.view, fixture.precision);
    const auto id = std::uint32_t(fixture.good.primitive.at(pixel.x, pixel.y));
    const TriangleInView triangle(fixture.view, bounds, corners_of(fixture.scene, id));
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
