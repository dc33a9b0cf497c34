#include "tests/mutants/plain/bvh.h"

#include <algorithm>

namespace plain {
namespace {

constexpr std::uint32_t leaf_size = 8;

Vec3<float> doubled_centre(const Triangle& t, const Box& whole) {
    Box box = Box::empty();
    for (const Vec3<float>& corner : t.corners) box.add(corner);
    return (box.low - whole.low) + (box.high - whole.low);
}

std::size_t longest_axis(const Box& box) {
    const Vec3<float> size = box.high - box.low;
    return std::size_t(std::ranges::max_element(size) - size.begin());
}

}  // namespace

Box Box::empty() {
    const float most = std::numeric_limits<float>::infinity();
    return {{most, most, most}, {-most, -most, -most}};
}

void Box::add(const Vec3<float>& p) {
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
    }
}

void Box::add(const Box& box) {
    add(box.low);
    add(box.high);
}

Bvh::Bvh(const Mesh& mesh) {
    std::uint32_t id = 0;
    for (const Primitive& primitive : mesh)
        for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3, ++id)
            triangles.push_back(
                {{primitive.positions[primitive.indices[i]], primitive.positions[primitive.indices[i + 1]],
                  primitive.positions[primitive.indices[i + 2]]},
                 id});
    if (triangles.empty()) return;
    nodes.emplace_back();
    build(0, 0, std::uint32_t(triangles.size()));
}

void Bvh::build(std::size_t node, std::uint32_t first, std::uint32_t count) {
    Box box = Box::empty();
    for (std::uint32_t i = first; i < first + count; ++i)
        for (const Vec3<float>& corner : triangles[i].corners) box.add(corner);
    nodes[node].box = box;
    if (count <= leaf_size) {
        nodes[node].first = first;
        nodes[node].count = count;
        return;
    }
    Box centres = Box::empty();
    for (std::uint32_t i = first; i != first + count; ++i) centres.add(doubled_centre(triangles[i], box));
    const std::size_t axis = longest_axis(centres);
    const auto begin = triangles.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](const Triangle& a, const Triangle& b) {
        return doubled_centre(a, box)[axis] < doubled_centre(b, box)[axis];
    });
    const auto child = std::uint32_t(nodes.size());
    nodes[node].first = child;
    nodes.resize(nodes.size() + 2);
    build(child, first, count / 2);
    build(child + 1, first + count / 2, count - count / 2);
}

}  // namespace plain
