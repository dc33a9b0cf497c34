/// Rays through the tree.
#pragma once

#include <optional>

#include "tests/mutants/plain/bvh.h"

namespace plain {

/// The direction's forward component is 1: t counts camera depth from the origin's.
template <class Real>
struct Ray {
    Vec3<Real> origin, direction;
};

/// Rounded once. A view that shows what lies behind its eye has rays that begin at near.
template <class Real>
Ray<Real> ray_through(const Camera& camera, int x, int y, double start) {
    const double u = camera.u(x), v = camera.v(y);
    const Vec3<double> across = u * camera.right + v * camera.up;
    if (camera.projection == Projection::perspective)
        return {rounded<Real>(camera.eye), rounded<Real>(across - camera.back)};
    const Vec3<double> along = camera.shear_x * camera.right + camera.shear_y * camera.up - camera.back;
    return {rounded<Real>(rounded<double>(camera.eye) + across + start * along), rounded<Real>(along)};
}

template <class Real>
struct Reach {
    Real low, high;
};

template <class Real>
struct Hit {
    Real t;
    std::uint32_t id = background;
};

/// Where the ray is inside the box; a little more than that, so that rounding loses nothing.
template <class Real>
std::optional<Real> entry(const Box& box, const Ray<Real>& ray, const Vec3<Real>& inverse,
                          Reach<Real> reach) {
    constexpr Real slack = 1 + 8 * std::numeric_limits<Real>::epsilon();
    for (std::size_t k = 0; k < 3; ++k) {
        Real t0 = (Real(box.low[k]) - ray.origin[k]) * inverse[k];
        Real t1 = (Real(box.high[k]) - ray.origin[k]) * inverse[k];
        if (t0 > t1) std::swap(t0, t1);
        t1 *= slack;
        if (t0 > reach.low) reach.low = t0;
        if (t1 < reach.high) reach.high = t1;
    }
    if (reach.low > reach.high) return std::nullopt;
    return reach.low;
}

/// Nodes that are still to be seen, and where the ray enters them.
template <class Real>
class Stack {
  public:
    void push(std::uint32_t node, const std::optional<Real>& entered_at) {
        if (entered_at) entries_[size_++] = {node, *entered_at};
    }
    bool is_empty() const { return size_ == 0; }
    auto pop() { return entries_[--size_]; }

  private:
    struct Entry {
        std::uint32_t node;
        Real entered_at;
    };
    std::array<Entry, 64> entries_;
    std::size_t size_ = 0;
};

/// meet(triangle, ray) is the t of a hit, or nothing.
template <class Real, class Meet>
Hit<Real> nearest_hit(const Bvh& tree, const Ray<Real>& ray, Reach<Real> reach, Meet meet) {
    Hit<Real> best{.t = reach.high};
    const Vec3<Real> inverse{1 / ray.direction[0], 1 / ray.direction[1], 1 / ray.direction[2]};
    const auto entry_of = [&](std::uint32_t node) {
        return entry(tree.nodes[node].box, ray, inverse, {reach.low, best.t});
    };
    Stack<Real> stack;
    if (!tree.nodes.empty()) stack.push(0, entry_of(0));
    while (!stack.is_empty()) {
        const auto [index, entered_at] = stack.pop();
        if (entered_at > best.t) continue;
        const Node& node = tree.nodes[index];
        if (node.count == 0) {
            const auto first = entry_of(node.first), second = entry_of(node.first + 1);
            const bool is_first_nearer = first && second && *first < *second;
            if (!is_first_nearer) stack.push(node.first, first);
            stack.push(node.first + 1, second);
            if (is_first_nearer) stack.push(node.first, first);
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const std::optional<Real> t = meet(tree.triangles[i], ray);
            if (t && *t >= reach.low && *t <= best.t) best = {*t, tree.triangles[i].id};
        }
    }
    return best;
}

template <class Real, class Meet>
Picture cast(const Mesh& mesh, const Camera& camera, Meet meet) {
    const Bvh tree(mesh);
    Picture picture(camera.width, camera.height);
    const double start = camera.projection == Projection::parallel ? std::min(0.0, camera.near) : 0;
    const Reach<Real> reach{Real(camera.near - start), Real(camera.far - start)};
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto hit = nearest_hit(tree, ray_through<Real>(camera, x, y, start), reach, meet);
            if (hit.id == background) continue;
            picture.ids[picture.at(x, y)] = hit.id;
            picture.depths[picture.at(x, y)] = float(hit.t + Real(start));
        }
    return picture;
}

}  // namespace plain
