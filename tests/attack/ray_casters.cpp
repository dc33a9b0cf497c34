#include "tests/attack/ray_casters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "tests/attack/lot.h"

namespace zproof::attack {

namespace {

template <class T>
using Vec = glm::vec<3, T>;
template <class T>
using Corners = std::array<Vec<T>, 3>;

template <class T>
constexpr double unit_roundoff = std::is_same_v<T, float> ? 0x1p-24 : 0x1p-53;

/// A little less than all, so that what is computed in double on the way stays within the promise.
constexpr double nearly_all = 1 - 0x1p-20;

/// Before it is rounded; depth is start + t.
struct ExactRay {
    glm::dvec3 origin, direction;
    double start = 0;
};

ExactRay ray_through(const View& view, const glm::dvec2& at) {
    const Camera& c = view.camera;
    const double u = c.window.left + (c.window.right - c.window.left) * at.x / view.width,
                 v = c.window.top - (c.window.top - c.window.bottom) * at.y / view.height;
    const glm::dvec3 eye(c.eye_world), across = u * c.right + v * c.up;
    if (c.projection == Projection::perspective) return {eye, across - c.back, 0};
    const glm::dvec3 direction = c.shear.x * c.right + c.shear.y * c.up - c.back;
    // what lies behind the eye is met as well: such rays begin on the near plane
    const double start = std::min(c.near_depth, 0.0);
    return {eye + across + start * direction, direction, start};
}

ExactRay aimed(const View& view, int x, int y, double aim_offset_px, std::uint64_t lot) {
    const glm::dvec2 offset = aim_offset_px * nearly_all * glm::dvec2(sign_of(lot, 0), sign_of(lot, 1));
    return ray_through(view, sampled_at(view, x, y) + offset);
}

/// Where a ray meets a triangle.
struct Met {
    double t = 0;
    std::array<double, 3> weights{};
};

/// Are all on one side, down to minus `tolerance` on the other?
template <class T>
bool are_inside(const std::array<T, 3>& w, T tolerance, Inside inside) {
    const auto [least, greatest] = std::minmax({w[0], w[1], w[2]});
    if (inside == Inside::open) return least > 0 || greatest < 0;
    return least >= -tolerance || greatest <= tolerance;
}

template <class T>
std::optional<Met> met_where(const std::array<T, 3>& w, T t) {
    const T sum = w[0] + w[1] + w[2];
    if (sum == 0 || !std::isfinite(t)) return std::nullopt;
    return Met{double(t), {double(w[0] / sum), double(w[1] / sum), double(w[2] / sum)}};
}

/// Signs of Pluecker products (Embree's robust test).
template <class T>
std::optional<Met> meet_by_pluecker(const Corners<T>& v, const Vec<T>& d, double tolerance, Inside inside) {
    const auto product = [&](std::size_t i, std::size_t k) {
        return glm::dot(glm::cross(v[k] - v[i], v[k] + v[i]), d);
    };
    const std::array<T, 3> w{product(1, 2), product(2, 0), product(0, 1)};
    const T sum = std::abs(w[0] + w[1] + w[2]);
    if (!are_inside<T>(w, sum * T(2 * unit_roundoff<T> + tolerance), inside)) return std::nullopt;
    const Vec<T> normal = glm::cross(v[1] - v[0], v[2] - v[0]);
    const T facing = glm::dot(normal, d);
    if (facing == 0) return std::nullopt;
    return met_where<T>(w, glm::dot(normal, v[0]) / facing);
}

/// Cramer's rule (Moeller and Trumbore 1997).
template <class T>
std::optional<Met> meet_by_cramer(const Corners<T>& v, const Vec<T>& d, const RayPrecision& precision,
                                  Inside inside) {
    const Vec<T> side1 = v[1] - v[0], side2 = v[2] - v[0], p = glm::cross(d, side2);
    const T determinant = glm::dot(side1, p);
    if (determinant == 0 || (std::abs(double(determinant)) < precision.least_determinant))
        return std::nullopt;
    const T inverse = T(1) / determinant;
    const Vec<T> from_v0 = -v[0], q = glm::cross(from_v0, side1);
    const T w1 = glm::dot(from_v0, p) * inverse, w2 = glm::dot(d, q) * inverse;
    const T tolerance = T(precision.barycentric_tolerance);
    const bool is_inside = inside == Inside::open
                               ? w1 > 0 && w2 > 0 && w1 + w2 < 1
                               : w1 >= -tolerance && w2 >= -tolerance && w1 + w2 <= 1 + tolerance;
    if (!is_inside) return std::nullopt;
    return Met{double(glm::dot(side2, q) * inverse), {double(1 - w1 - w2), double(w1), double(w2)}};
}

/// Corners sheared into the ray's space (Woop, Benthin and Wald 2013).
template <class T>
std::optional<Met> meet_sheared(const Corners<T>& v, const Vec<T>& d, double tolerance, Inside inside) {
    int kz = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(d[axis]) > std::abs(d[kz])) kz = axis;
    const int kx = (kz + 1) % 3, ky = (kx + 1) % 3;
    const T shear_x = d[kx] / d[kz], shear_y = d[ky] / d[kz], scale = T(1) / d[kz];
    std::array<Vec<T>, 3> s;
    for (std::size_t i = 0; i < 3; ++i)
        s[i] = {v[i][kx] - shear_x * v[i][kz], v[i][ky] - shear_y * v[i][kz], scale * v[i][kz]};
    const auto product = [&](std::size_t i, std::size_t k) { return s[i].x * s[k].y - s[i].y * s[k].x; };
    const std::array<T, 3> w{product(2, 1), product(0, 2), product(1, 0)};
    const T sum = w[0] + w[1] + w[2];
    if (!are_inside<T>(w, std::abs(sum) * T(tolerance), inside) || sum == 0) return std::nullopt;
    return met_where<T>(w, (w[0] * s[0].z + w[1] * s[1].z + w[2] * s[2].z) / sum);
}

/// One after the other: the nearest hit between near and far wins, and of equal ones the last. T is the
/// arithmetic in which depths are compared.
template <class T>
class NearestHit {
  public:
    explicit NearestHit(const View& view)
        : near_(T(view.camera.near_depth)), far_(T(view.camera.far_depth)) {}
    /// `shown` is what the frame says of a hit at this depth.
    void take(std::uint32_t triangle, T depth, double shown) {
        if (!(depth >= near_ && depth <= far_) || depth > depth_) return;
        depth_ = depth;
        shown_ = float(shown);
        id_ = PrimitiveId(triangle);
    }
    void show(Frame& frame, int x, int y) const {
        frame.primitive.at(x, y) = id_;
        frame.camera_depth.at(x, y) = id_ == PrimitiveId::none ? background_depth : shown_;
    }

  private:
    T near_, far_, depth_ = std::numeric_limits<T>::infinity();
    float shown_ = 0;
    PrimitiveId id_ = PrimitiveId::none;
};

/// The number farthest from `p` in the direction of `by`, but no farther than that.
template <class T>
T moved(double p, double by) {
    T there = T(p + by);
    while (std::abs(double(there) - p) > std::abs(by)) there = std::nextafter(there, T(p));
    return there;
}

template <class T>
class Caster {
  public:
    Caster(const RayPrecision& precision, const Scene& scene, const View& view, const RayChoices& choices)
        : precision_(precision), scene_(scene), view_(view), choices_(choices) {
        for (std::size_t i = 0; i < scene.vertices.position_world.size(); ++i) {
            const std::uint64_t lot = mixed(choices.seed, i);
            const glm::dvec3 ways{sign_of(lot, 0), sign_of(lot, 1), sign_of(lot, 2)};
            const glm::dvec3 p(scene.vertices.position_world[i]),
                by = precision.world_absolute * nearly_all * ways;
            p_world_.push_back({moved<T>(p.x, by.x), moved<T>(p.y, by.y), moved<T>(p.z, by.z)});
        }
    }

    Frame frame() const {
        Frame frame({view_.width, view_.height});
        for (int y = 0; y < view_.height; ++y)
            for (int x = 0; x < view_.width; ++x) {
                const std::uint64_t lot = mixed(choices_.seed, std::uint64_t(y) << 32 | std::uint64_t(x));
                NearestHit<T> hit(view_);
                const ExactRay ray = aimed(view_, x, y, precision_.aim_offset_px, lot);
                for (std::uint32_t t = 0; t < scene_.triangles.size(); ++t) meet(t, ray, lot, hit);
                hit.show(frame, x, y);
            }
        return frame;
    }

  private:
    void meet(std::uint32_t triangle, const ExactRay& ray, std::uint64_t lot, NearestHit<T>& hit) const {
        const double more = (precision_.direction_roundings - 1) * unit_roundoff<T> * nearly_all;
        const glm::dvec3 ways{sign_of(lot, 2), sign_of(lot, 3), sign_of(lot, 4)};
        const Vec<T> origin(ray.origin), direction(ray.direction * (1.0 + more * ways));
        const glm::uvec3& corners = scene_.triangles[triangle];
        const Corners<T> p{p_world_[corners.x], p_world_[corners.y], p_world_[corners.z]};
        const auto met = test({p[0] - origin, p[1] - origin, p[2] - origin}, direction);
        if (!met) return;
        double depth = double(T(ray.start) + T(met->t));
        if (precision_.hit_point == HitPoint::barycentrics) depth = depth_of_point(p, met->weights);
        hit.take(triangle, T(depth), depth);
    }

    std::optional<Met> test(const Corners<T>& v, const Vec<T>& d) const {
        const double tolerance = precision_.barycentric_tolerance;
        switch (precision_.test) {
            case RayTest::pluecker:
                return meet_by_pluecker<T>(v, d, tolerance, choices_.inside);
            case RayTest::moeller_trumbore:
                return meet_by_cramer<T>(v, d, precision_, choices_.inside);
            case RayTest::woop:
                return meet_sheared<T>(v, d, tolerance, choices_.inside);
        }
        return std::nullopt;
    }

    double depth_of_point(const Corners<T>& p, const std::array<double, 3>& weights) const {
        const Vec<T> point = T(weights[0]) * p[0] + T(weights[1]) * p[1] + T(weights[2]) * p[2];
        return -double(glm::dot(Vec<T>(view_.camera.back), point - Vec<T>(view_.camera.eye_world)));
    }

    RayPrecision precision_;
    const Scene& scene_;
    const View& view_;
    RayChoices choices_;
    std::vector<Vec<T>> p_world_;
};

/// A triangle as a plane, and the axes in which it is asked on which side of the edges a hit lies.
class PlaneOfTriangle {
  public:
    PlaneOfTriangle(const Corners<double>& v, double least_corner_sine) : v_(v) {
        const glm::dvec3 side1 = v[0] - v[1], side2 = v[2] - v[1], product = glm::cross(side1, side2);
        const double length = glm::length(product);
        is_drawn_ = length > 0 && length >= least_corner_sine * glm::length(side1) * glm::length(side2);
        normal_ = product / length;
        offset_ = glm::dot(normal_, v[1]);
        for (int axis = 1; axis < 3; ++axis)
            if (std::abs(normal_[axis]) > std::abs(normal_[dropped_])) dropped_ = axis;
    }

    std::optional<double> meet(const glm::dvec3& origin, const glm::dvec3& direction,
                               double least_grazing_sine, Inside inside) const {
        if (!is_drawn_) return std::nullopt;
        const double facing = glm::dot(normal_, direction);
        if (std::abs(facing) <= least_grazing_sine) return std::nullopt;
        const double t = (offset_ - glm::dot(normal_, origin)) / facing;
        const glm::dvec3 hit = origin + t * direction;
        const int i = (dropped_ + 1) % 3, k = (dropped_ + 2) % 3;
        std::array<double, 3> sides{};
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 &a = v_[c], &b = v_[(c + 1) % 3];
            sides[c] = (b[i] - a[i]) * (hit[k] - a[k]) - (b[k] - a[k]) * (hit[i] - a[i]);
        }
        if (!are_inside<double>(sides, 0, inside)) return std::nullopt;
        return t;
    }

  private:
    Corners<double> v_;
    glm::dvec3 normal_{};
    double offset_ = 0;
    int dropped_ = 0;
    bool is_drawn_ = false;
};

}  // namespace

Frame cast(const RayPrecision& precision, const Scene& scene, const View& view, const RayChoices& choices) {
    return precision.arithmetic == Arithmetic::float32
               ? Caster<float>(precision, scene, view, choices).frame()
               : Caster<double>(precision, scene, view, choices).frame();
}

Frame cast(const PlaneRayPrecision& precision, const Scene& scene, const View& view,
           const RayChoices& choices) {
    const Camera& c = view.camera;
    const glm::dvec3 eye(c.eye_world);
    std::vector<PlaneOfTriangle> planes;
    for (const glm::uvec3& t : scene.triangles) {
        Corners<double> v;
        for (int i = 0; i < 3; ++i) v[std::size_t(i)] = glm::dvec3(scene.vertices.position_world[t[i]]) - eye;
        planes.emplace_back(v, precision.least_corner_sine);
    }
    Frame frame({view.width, view.height});
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const std::uint64_t lot = mixed(choices.seed, std::uint64_t(y) << 32 | std::uint64_t(x));
            const ExactRay ray = aimed(view, x, y, precision.aim_offset_px, lot);
            const glm::dvec3 origin = ray.origin - eye, direction = glm::normalize(ray.direction);
            NearestHit<double> hit(view);
            for (std::uint32_t t = 0; t < planes.size(); ++t)
                if (const auto at =
                        planes[t].meet(origin, direction, precision.least_grazing_sine, choices.inside)) {
                    const double depth = -glm::dot(c.back, origin + *at * direction);
                    // the rounding to a float is a part of what is declared
                    const double error =
                        std::max(0.0, precision.depth_relative - 0x1p-24) * nearly_all * sign_of(lot, 2);
                    hit.take(t, depth, depth * (1 + error));
                }
            hit.show(frame, x, y);
        }
    return frame;
}

}  // namespace zproof::attack
