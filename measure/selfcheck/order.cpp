#include <algorithm>
#include <utility>

#include "measure/selfcheck/frame_mapping.h"
#include "measure/selfcheck/variants.h"

namespace zproof::measure {
namespace {

Frame as_it_is(const Frame& frame) { return frame; }

Pixel same_pixel(int x, int y) { return {x, y}; }

}  // namespace

Scene in_reversed_order(const Scene& scene) {
    Scene reversed = scene;
    std::ranges::reverse(reversed.triangles);
    std::ranges::reverse(reversed.parts);
    std::uint32_t next = 0;
    for (Part& part : reversed.parts) part.first_triangle = std::exchange(next, next + part.triangle_count);
    return reversed;
}

std::vector<VariantPicture> pictures_of_reversed_order(const Scene& scene, const View& view) {
    const auto count = std::uint32_t(scene.triangles.size());
    const auto renamed = [count](PrimitiveId id, Pixel) {
        return std::uint32_t(id) < count ? PrimitiveId(count - 1 - std::uint32_t(id)) : id;
    };
    const auto expected = [renamed](const Frame& original) {
        return mapped_frame(original, original.size(), same_pixel, renamed);
    };
    return {{view, view, as_it_is, expected}};
}

Scene wound_the_other_way(const Scene& scene) {
    Scene turned = scene;
    for (glm::uvec3& t : turned.triangles) std::swap(t.y, t.z);
    return turned;
}

std::vector<VariantPicture> same_picture(const Scene&, const View& view) {
    return {{view, view, as_it_is, as_it_is}};
}

}  // namespace zproof::measure
