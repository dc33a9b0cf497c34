#include "brute_force.h"

#include <cmath>

namespace zproof::brute_force {

namespace {

using Vector = Vector3<Rational>;

Rational determinant(const Vector& a, const Vector& b, const Vector& c) { return dot(a, cross(b, c)); }
Vector vector(const ImagePoint& p) { return {p.x, p.y, p.d}; }
Functional functional(const Vector& v) { return {v.x, v.y, v.z}; }
Functional difference(const Functional& f, const Functional& g) { return {f.a - g.a, f.b - g.b, f.c - g.c}; }

/// Solves p = along(x, y, t) for the place in the image: Cramer's rule on [step_x step_y direction].
Corner corner_at(const ViewRay<Rational>& ray, const Vector& p_world) {
    const Vector v = p_world - ray.origin;
    const Rational all = determinant(ray.step_x, ray.step_y, ray.direction);
    const Rational x = determinant(v, ray.step_y, ray.direction) / all;
    const Rational y = determinant(ray.step_x, v, ray.direction) / all;
    const Rational t = determinant(ray.step_x, ray.step_y, v) / all;
    return {{x, y, ray.projection == Projection::perspective ? t : Rational(1)}, t};
}

bool same_position(const glm::vec3& p, const glm::vec3& q) { return p == q; }

}  // namespace

Picture::Picture(const Neighbourhood& around)
    : around_(around), perspective_(around.view.camera.projection == Projection::perspective) {
    for (const Neighbour& n : around.neighbours) triangles_.push_back(draw(n));
}

auto Picture::draw(const Neighbour& n) const -> Triangle {
    const ViewRay<Rational> ray(around_.view, around_.x, around_.y);
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.corner[i] = corner_at(ray, exactly<Rational>(glm::dvec3(n.p_world[i])));
    const auto at = [&](std::size_t i) { return vector(triangle.corner[i % 3].at); };
    const Rational area = determinant(at(0), at(1), at(2));
    triangle.orientation = area.sign();
    Vector inverse_depth{0, 0, 0};
    for (std::size_t i = 0; i < 3 && triangle.orientation != 0; ++i) {
        const Vector line = cross(at(i + 1), at(i + 2));
        triangle.edge[i] = functional(Rational(triangle.orientation) * line);
        inverse_depth =
            inverse_depth + ((perspective_ ? Rational(1) : -triangle.corner[i].depth) / area) * line;
    }
    triangle.inverse_depth = functional(inverse_depth);
    return triangle;
}

Set Picture::square() const {
    const Rational h(around_.eps_px);
    return {{1, 0, h}, {-1, 0, h}, {0, 1, h}, {0, -1, h}};
}

/// Near and far as places of inverse depth in double, moved by the triangle's own slack.
Set Picture::clip_planes(std::size_t index, const Functional& inverse_depth, Plane plane) const {
    const Neighbour& n = around_.neighbours[index];
    const Camera& camera = around_.view.camera;
    const double wider = plane == Plane::as_far_as_it_may_be ? 1 : -1;
    const double near = camera.near_depth - wider * n.near_slack;
    const double far = camera.far_depth + wider * n.far_slack;
    const auto limit = [&](double depth) {
        return Functional{0, 0, Rational(perspective_ ? 1 / depth : -depth)};
    };
    const Functional nowhere{0, 0, -1};
    if (plane == Plane::as_near_as_it_may_be && (!std::isfinite(near) || far < (perspective_ ? 0 : near)))
        return {nowhere};
    Set set;
    if (std::isfinite(near) && (!perspective_ || near > 0))
        set.push_back(difference(limit(near), inverse_depth));
    if (std::isfinite(far)) set.push_back(difference(inverse_depth, limit(far)));
    return set;
}

/// The triangle's own edges in the square, as far as the clip planes may admit it; only where it has area.
Set Picture::outline(std::size_t index) const {
    const Triangle& t = triangles_[index];
    Set set = square();
    set.insert(set.end(), t.edge.begin(), t.edge.end());
    for (const Functional& f : clip_planes(index, t.inverse_depth, Plane::as_far_as_it_may_be))
        set.push_back(f);
    return set;
}

bool Picture::reaches(std::size_t index) const { return !is_empty(outline(index)); }

bool Picture::is_clipped(std::size_t index) const {
    const Triangle& t = triangles_[index];
    const Neighbour& n = around_.neighbours[index];
    const Camera& camera = around_.view.camera;
    if (n.nearest > camera.near_depth && n.farthest < camera.far_depth) return false;
    Set inside = square();
    inside.insert(inside.end(), t.edge.begin(), t.edge.end());
    return !is_covered(inside, {clip_planes(index, t.inverse_depth, Plane::as_near_as_it_may_be)});
}

bool Picture::is_visible(std::size_t index) const {
    std::vector<Set> hiding;
    for (std::size_t o = 0; o < triangles_.size(); ++o) {
        const Triangle& t = triangles_[o];
        if (o == index || t.orientation == 0) continue;
        Set set = clip_planes(o, t.inverse_depth, Plane::as_near_as_it_may_be);
        set.insert(set.end(), t.edge.begin(), t.edge.end());
        set.push_back(difference(t.inverse_depth, triangles_[index].inverse_depth));
        hiding.push_back(set);
    }
    return !is_covered(outline(index), hiding);
}

/// +1 where `other` has this edge too and lies on the same side of it, -1 on the other side.
std::optional<int> Picture::side_of(std::size_t index, std::size_t edge, std::size_t other) const {
    if (triangles_[other].orientation == 0) return std::nullopt;
    const CornersWorld &p = around_.neighbours[index].p_world, &q = around_.neighbours[other].p_world;
    const glm::vec3 &a = p[(edge + 1) % 3], &b = p[(edge + 2) % 3];
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 &c = q[(i + 1) % 3], &d = q[(i + 2) % 3];
        if (!(same_position(a, c) && same_position(b, d)) && !(same_position(a, d) && same_position(b, c)))
            continue;
        return sign(dot(Vector{triangles_[index].edge[edge].a, triangles_[index].edge[edge].b,
                               triangles_[index].edge[edge].c},
                        vector(triangles_[other].corner[i].at)));
    }
    return std::nullopt;
}

bool Picture::is_in_front(std::size_t occluder, std::size_t seen, DepthRule rule) const {
    const Neighbour &front = around_.neighbours[occluder], &back = around_.neighbours[seen];
    const bool certainly = front.least_inverse_depth > back.greatest_inverse_depth;
    if (rule == DepthRule::bounded) return certainly;
    const bool certainly_not = front.greatest_inverse_depth < back.least_inverse_depth;
    return certainly ||
           (!certainly_not && triangles_[occluder].inverse_depth.c >= triangles_[seen].inverse_depth.c);
}

std::vector<std::size_t> Picture::in_front_of(std::size_t seen, DepthRule rule) const {
    std::vector<std::size_t> found;
    for (std::size_t o = 0; o < triangles_.size(); ++o)
        if (o != seen && triangles_[o].orientation != 0 && is_in_front(o, seen, rule)) found.push_back(o);
    return found;
}

Set Picture::cover(std::size_t occluder, std::optional<std::size_t> seen) const {
    Set set = clip_planes(occluder, triangles_[occluder].inverse_depth, Plane::as_near_as_it_may_be);
    for (std::size_t e = 0; e < 3; ++e)
        if (!seen || side_of(occluder, e, *seen) != 1) set.push_back(triangles_[occluder].edge[e]);
    return set;
}

/// Is it cut in the square, or has it an edge there that none of them goes on beyond?
bool Picture::may_part(std::size_t occluder, const std::vector<std::size_t>& occluders,
                       std::optional<std::size_t> seen) const {
    for (const Functional& f :
         clip_planes(occluder, triangles_[occluder].inverse_depth, Plane::as_near_as_it_may_be)) {
        Set beyond = outline(occluder);
        beyond.push_back({-f.a, -f.b, -f.c});
        if (!is_empty(beyond)) return true;
    }
    for (std::size_t e = 0; e < 3; ++e) {
        bool goes_on = seen && side_of(occluder, e, *seen) == 1;
        for (const std::size_t o : occluders) goes_on = goes_on || side_of(occluder, e, o) == -1;
        const Functional& edge = triangles_[occluder].edge[e];
        Set on_edge = outline(occluder);
        on_edge.push_back({-edge.a, -edge.b, -edge.c});
        if (!goes_on && !is_empty(on_edge)) return true;
    }
    return false;
}

/// One at a time is left out, until none may part.
std::vector<std::size_t> Picture::sheet_of(std::vector<std::size_t> occluders,
                                           std::optional<std::size_t> seen) const {
    for (std::size_t i = 0; i < occluders.size();)
        if (may_part(occluders[i], occluders, seen)) {
            occluders.erase(occluders.begin() + std::ptrdiff_t(i));
            i = 0;
        } else {
            ++i;
        }
    return occluders;
}

bool Picture::leaves_bare(const std::vector<std::size_t>& occluders, EdgeRule rule,
                          std::optional<std::size_t> seen) const {
    std::vector<Set> sets;
    for (const std::size_t o : rule == EdgeRule::separate ? sheet_of(occluders, seen) : occluders) {
        bool apart = false;
        for (std::size_t e = 0; seen && e < 3; ++e) apart = apart || side_of(o, e, *seen) == -1;
        if (!apart) sets.push_back(cover(o, seen));
    }
    return !is_covered(square(), sets);
}

/// Do its edges, each moved outwards by its own error, have a point in common within what else it is
/// displaced by, and as far as the clip planes may admit it?
bool Picture::is_inside_by_rounding(std::size_t index) const {
    const Neighbour& n = around_.neighbours[index];
    const double most = std::ranges::max(n.edge_rounding_px),
                 moved = std::max(0.0, std::min(n.bounds.eps_px, around_.eps_px) - most);
    if (most == 0 || !std::isfinite(most + moved)) return false;
    const auto at = [&](std::size_t i) { return vector(triangles_[index].corner[i % 3].at); };
    for (const int side : {1, -1}) {
        const Rational h(moved);
        Set set{{1, 0, h}, {-1, 0, h}, {0, 1, h}, {0, -1, h}};
        if (triangles_[index].orientation != 0)
            for (const Functional& f :
                 clip_planes(index, triangles_[index].inverse_depth, Plane::as_far_as_it_may_be))
                set.push_back(f);
        for (std::size_t i = 0; i < 3; ++i) {
            Functional f = functional(Rational(side) * cross(at(i + 1), at(i + 2)));
            f.c += Rational(n.edge_rounding_px[i]) * Rational(abs(f.a) + abs(f.b));
            set.push_back(f);
        }
        if (!is_empty(set)) return true;
    }
    return false;
}

bool Picture::holds(std::size_t index, Rules rules) const {
    return (reaches(index) || is_inside_by_rounding(index)) &&
           leaves_bare(in_front_of(index, rules.depth), rules.edges, index);
}

bool Picture::holds_background(EdgeRule rule) const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
        if (triangles_[i].orientation != 0) all.push_back(i);
    return leaves_bare(all, rule, std::nullopt);
}

}  // namespace zproof::brute_force
