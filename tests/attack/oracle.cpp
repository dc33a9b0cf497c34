#include "tests/attack/oracle.h"

#include <cmath>

namespace zproof::attack {

/// A point before the divide: it is seen at (x / w, y / w).
struct Projected {
    Number x, y, w, depth;

    bool operator==(const Projected&) const = default;
};

namespace {

using Vector = std::array<Number, 3>;

Vector exact(const glm::dvec3& v) { return {Number(v.x), Number(v.y), Number(v.z)}; }

Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
    return {Number(a[1] * b[2] - a[2] * b[1]), Number(a[2] * b[0] - a[0] * b[2]),
            Number(a[0] * b[1] - a[1] * b[0])};
}

using Polygon = std::vector<Projected>;

class ExactCamera {
  public:
    explicit ExactCamera(const View& view) : c_(view.camera), eye_(exact(glm::dvec3(c_.eye_world))) {
        // p_world - eye = x right + y up + z back, whether or not these are orthonormal: Cramer's rule
        const Vector right = exact(c_.right), up = exact(c_.up), back = exact(c_.back);
        rows_ = {cross(up, back), cross(back, right), cross(right, up)};
        const Number volume = dot(right, rows_[0]);
        for (Vector& row : rows_)
            for (Number& entry : row) entry /= volume;
        per_u_ = view.width / (Number(c_.window.right) - Number(c_.window.left));
        per_v_ = view.height / (Number(c_.window.top) - Number(c_.window.bottom));
    }

    Projected operator()(const glm::vec3& p_world) const {
        Vector p = exact(glm::dvec3(p_world));
        for (std::size_t i = 0; i < 3; ++i) p[i] -= eye_[i];
        const Number depth = -dot(rows_[2], p);
        const bool is_perspective = c_.projection == Projection::perspective;
        const Number w = is_perspective ? depth : Number(1);
        const Number u = dot(rows_[0], p) - (is_perspective ? Number(0) : Number(depth * c_.shear.x)),
                     v = dot(rows_[1], p) - (is_perspective ? Number(0) : Number(depth * c_.shear.y));
        return {(u - Number(c_.window.left) * w) * per_u_, (Number(c_.window.top) * w - v) * per_v_, w,
                depth};
    }

  private:
    const Camera& c_;
    Vector eye_;
    std::array<Vector, 3> rows_;
    Number per_u_, per_v_;
};

template <class Distance>
Polygon cut(const Polygon& polygon, const Distance& distance) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Projected &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const Number at_a = distance(a), at_b = distance(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a >= 0) == (at_b >= 0)) continue;
        const Number share = at_a / (at_a - at_b);
        kept.push_back({a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share, a.w + (b.w - a.w) * share,
                        a.depth + (b.depth - a.depth) * share});
    }
    return kept;
}

Polygon what_is_left(Polygon polygon, const Planes& planes) {
    polygon = cut(polygon, [&](const Projected& p) { return Number(p.depth - planes.near); });
    if (!planes.far) return polygon;
    return cut(polygon, [&](const Projected& p) { return Number(*planes.far - p.depth); });
}

Polygon part_near_the_picture(Polygon polygon) {
    const Number far = farthest_place_px;
    polygon = cut(polygon, [&](const Projected& p) { return Number(p.x + far * p.w); });
    polygon = cut(polygon, [&](const Projected& p) { return Number(far * p.w - p.x); });
    polygon = cut(polygon, [&](const Projected& p) { return Number(p.y + far * p.w); });
    return cut(polygon, [&](const Projected& p) { return Number(far * p.w - p.y); });
}

Image<double> rounded_image(const ExactImage& image) {
    Image<double> rounded;
    for (const auto& c : image) rounded.push_back({double(c.x), double(c.y), double(c.front)});
    return rounded;
}

}  // namespace

Planes planes_of(const View& view) {
    const Camera& c = view.camera;
    return {Number(c.near_depth),
            std::isfinite(c.far_depth) ? std::optional(Number(c.far_depth)) : std::nullopt};
}

ExactScene::ExactScene(const Scene& scene, const View& view, const Planes& planes)
    : view_(view), is_perspective_(view.camera.projection == Projection::perspective) {
    const ExactCamera camera(view_);
    std::vector<Projected> projected;
    for (const glm::vec3& p_world : scene.vertices.position_world) projected.push_back(camera(p_world));
    for (const glm::uvec3& t : scene.triangles) {
        const Polygon whole{projected[t.x], projected[t.y], projected[t.z]},
            left = what_is_left(whole, planes), near_by = part_near_the_picture(left);
        ExactImage image = divided(near_by);
        left_by_planes_.push_back(divided(left));
        is_whole_.push_back(near_by == whole);
        is_near_by_.push_back(near_by == left);
        rounded_.push_back(rounded_image(image));
        images_.push_back(std::move(image));
    }
}

ExactImage ExactScene::divided(const Polygon& polygon) const {
    ExactImage image;
    for (const Projected& p : polygon)
        image.push_back({p.x / p.w, p.y / p.w, is_perspective_ ? Number(1 / p.depth) : Number(-p.depth)});
    return image;
}

Number ExactScene::depth(const Number& front) const {
    return is_perspective_ ? Number(1 / front) : Number(-front);
}

ExactPlace place_of(const View& view, int x, int y) {
    return {Number(x) + Number(1) / 2 + Number(view.sample.offset_px.x),
            Number(y) + Number(1) / 2 + Number(view.sample.offset_px.y)};
}

Place<double> rounded_place_of(const View& view, int x, int y) {
    const glm::dvec2 at = sampled_at(view, x, y);
    return {at.x, at.y};
}

}  // namespace zproof::attack
