#include <cmath>

#include "selftest/catalogue.h"
#include "selftest/fault_pixel.h"

namespace zproof::selftest {
namespace {

/// Every id that is not background becomes another; depths stay.
std::function<Frame(const Fixture&)> each_id(
    const std::function<std::uint32_t(const Fixture&, std::uint32_t)>& renamed) {
    return [=](const Fixture& fixture) {
        Frame frame = fixture.good;
        for (PrimitiveId& id : frame.primitive.pixels())
            if (id != PrimitiveId::none) id = PrimitiveId{renamed(fixture, std::uint32_t(id))};
        return frame;
    };
}

Frame with_two_swapped(const Fixture& fixture) {
    const CommonestIds ids = commonest_ids(fixture.good);
    Frame frame = fixture.good;
    for (PrimitiveId& id : frame.primitive.pixels()) {
        if (id == ids.first)
            id = ids.second;
        else if (id == ids.second)
            id = ids.first;
    }
    return frame;
}

std::uint32_t within_its_part(const Fixture& fixture, std::uint32_t id) {
    for (const Part& part : fixture.scene.parts)
        if (id >= part.first_triangle && id - part.first_triangle < part.triangle_count)
            return id - part.first_triangle;
    return id;
}

/// 11 significant bits, as float16 keeps them.
std::uint32_t as_half_float(std::uint32_t id) {
    if (id < 2048) return id;
    int exponent = 0;
    const double mantissa = std::frexp(double(id), &exponent);
    return std::uint32_t(std::ldexp(std::nearbyint(std::ldexp(mantissa, 11)), exponent - 11));
}

/// The id of the pixel to the left, where that is no background.
Frame with_ids_one_pixel_right(const Fixture& fixture) {
    Frame frame = fixture.good;
    for (int y = 0; y < fixture.view.height; ++y)
        for (int x = 1; x < fixture.view.width; ++x) {
            const PrimitiveId left = fixture.good.primitive.at(x - 1, y);
            PrimitiveId& here = frame.primitive.at(x, y);
            if (here != PrimitiveId::none && left != PrimitiveId::none) here = left;
        }
    return frame;
}

}  // namespace

std::vector<Fault> faults_of_ids() {
    const Expected outside{.classes = {PixelClass::outside}, .count = {}};
    const auto count_of = [](const Fixture& fixture) {
        return std::uint32_t(fixture.scene.triangles.size());
    };
    return {
        {"ids_swapped", "the two largest triangles bear each other's ids", outside, with_two_swapped},
        {"ids_off_by_one", "every id is one too large", outside,
         each_id([](const Fixture&, std::uint32_t id) { return id + 1; })},
        {"ids_one_less", "every id is one too small", outside,
         each_id([](const Fixture&, std::uint32_t id) { return id == 0 ? 0 : id - 1; })},
        {"ids_of_the_pair", "even and odd ids change places", outside,
         each_id([](const Fixture&, std::uint32_t id) { return id ^ 1; })},
        {"ids_from_the_end", "triangles are counted from the last one", outside,
         each_id([=](const Fixture& fixture, std::uint32_t id) { return count_of(fixture) - 1 - id; })},
        {"ids_within_the_part", "triangles are counted anew in every part", outside,
         each_id(within_its_part)},
        {"ids_of_12_bits", "ids keep their low 12 bits", outside,
         each_id([](const Fixture&, std::uint32_t id) { return id & 0xFFF; })},
        {"ids_as_half_float", "ids went through a float16 image", outside,
         each_id([](const Fixture&, std::uint32_t id) { return as_half_float(id); })},
        {"ids_of_vertices", "the id is that of the triangle's first vertex", outside,
         each_id([=](const Fixture& fixture, std::uint32_t id) {
             return std::min(fixture.scene.triangles[id].x, count_of(fixture) - 1);
         })},
        {"ids_one_pixel_right", "ids lie one pixel to the right of their depths", outside,
         with_ids_one_pixel_right},
    };
}

}  // namespace zproof::selftest
