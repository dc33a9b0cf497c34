#include "scenes/concave_faces.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <vector>

#include "math/interval.h"
#include "math/rational.h"
#include "scenes/limits.h"

namespace zproof {
namespace {

/// A corner of a face, seen along an axis.
struct Corner {
    std::uint32_t vertex;
    glm::dvec2 p;
};
using Outline = std::vector<Corner>;

template <class Number>
Number doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const Number ax = a.x, ay = a.y;
    return (Number(b.x) - ax) * (Number(c.y) - ay) - (Number(b.y) - ay) * (Number(c.x) - ax);
}

template <class Number>
Number doubled_area(const Outline& face) {
    Number sum = 0;
    for (std::size_t i = 2; i < face.size(); ++i)
        sum = sum + doubled_area<Number>(face[0].p, face[i - 1].p, face[i].p);
    return sum;
}

/// The sign of the area: +1 counter-clockwise, -1 clockwise, 0 none.
int turn(const auto&... outline) {
    try {
        return sign(doubled_area<Interval>(outline...));
    } catch (const UndecidedSign&) {
        return sign(doubled_area<Rational>(outline...));
    }
}

/// The face whose fan the triangles are, seen along the axis that its normal is nearest to.
Outline outline_of(std::span<const glm::uvec3> fan, const Positions& positions) {
    glm::dvec3 normal(0);
    for (const glm::uvec3& t : fan) {
        const glm::dvec3 a(positions[t.x]), b(positions[t.y]), c(positions[t.z]);
        normal += glm::cross(b - a, c - a);
    }
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto seen = [&](std::uint32_t vertex) {
        const glm::dvec3 p(positions[vertex]);
        return Corner{vertex, {p[(axis + 1) % 3], p[(axis + 2) % 3]}};
    };
    Outline outline{seen(fan[0].x), seen(fan[0].y)};
    for (const glm::uvec3& t : fan) outline.push_back(seen(t.z));
    return outline;
}

/// Triangles that all turn alike cover each point as often as the outline goes around it.
bool is_covered_by_fan(const Outline& face) {
    int side = 0;
    for (std::size_t i = 2; i < face.size(); ++i) {
        const int turned = turn(face[0].p, face[i - 1].p, face[i].p);
        if (turned * side < 0) return false;
        if (turned != 0) side = turned;
    }
    return true;
}

/// The least box around points; of none, one that meets no other.
struct Box {
    glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};

Box around(const Box& a, const Box& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

/// Boxes around the corners that are left, in a binary tree of halves by x and y in turn.
class CornerBoxes {
  public:
    explicit CornerBoxes(const Outline& face)
        : leaves_(std::bit_ceil(face.size())), leaf_(face.size()), boxes_(2 * leaves_) {
        std::vector<std::size_t> corners(face.size());
        std::iota(corners.begin(), corners.end(), std::size_t{0});
        halve(face, corners, leaves_, 0);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            leaf_[corners[i]] = leaves_ + i;
            boxes_[leaves_ + i] = {face[corners[i]].p, face[corners[i]].p};
        }
        for (std::size_t node = leaves_; --node > 0;) join(node);
    }

    void remove(std::size_t corner) {
        std::size_t node = leaf_[corner];
        boxes_[node] = {};
        while ((node /= 2) > 0) join(node);
    }

    /// Is there a corner whose box, and each box around that, passes?
    template <class Test>
    bool any(const Test& passes, std::size_t node = 1) const {
        if (!passes(boxes_[node])) return false;
        return node >= leaves_ || any(passes, 2 * node) || any(passes, 2 * node + 1);
    }

  private:
    /// Puts the corners into the order of their leaves, of which there are so many.
    static void halve(const Outline& face, std::span<std::size_t> corners, std::size_t leaves, int axis) {
        const std::size_t half = leaves / 2;
        if (half == 0) return;
        if (corners.size() > half) {
            std::ranges::nth_element(corners, corners.begin() + std::ptrdiff_t(half), {},
                                     [&](std::size_t corner) { return face[corner].p[axis]; });
            halve(face, corners.subspan(half), half, 1 - axis);
        }
        halve(face, corners.first(std::min(half, corners.size())), half, 1 - axis);
    }

    void join(std::size_t node) { boxes_[node] = around(boxes_[2 * node], boxes_[2 * node + 1]); }

    std::size_t leaves_;
    std::vector<std::size_t> leaf_;  ///< the place in boxes_, by corner
    std::vector<Box> boxes_;         ///< those within boxes_[i] are 2 i and 2 i + 1
};

/// A closed triangle that turns as `side` says.
struct Triangle {
    glm::dvec2 a, b, c;
    int side;
    Box box = around({glm::min(a, b), glm::max(a, b)}, {c, c});

    /// Of a point: is it inside, and no corner? Of a larger box: false only where it is outside for certain.
    bool may_hold(const Box& other) const {
        if (glm::any(glm::lessThan(box.high, other.low)) || glm::any(glm::lessThan(other.high, box.low)))
            return false;
        const glm::dvec2& p = other.low;
        if (p != other.high)
            return !(lies_beyond(a, b, other) || lies_beyond(b, c, other) || lies_beyond(c, a, other));
        return p != a && p != b && p != c && turn(c, a, p) * side >= 0 && turn(a, b, p) * side >= 0 &&
               turn(b, c, p) * side >= 0;
    }

  private:
    /// Is the box's innermost corner certainly on the edge's outer side?
    bool lies_beyond(const glm::dvec2& from, const glm::dvec2& to, const Box& other) const {
        const bool is_low_x = (to.y > from.y) == (side > 0), is_low_y = (to.x < from.x) == (side > 0);
        const glm::dvec2 innermost{(is_low_x ? other.low : other.high).x,
                                   (is_low_y ? other.low : other.high).y};
        const Interval area = doubled_area<Interval>(from, to, innermost);
        return side > 0 ? area.high() < 0 : area.low() > 0;
    }
};

/// What is left of a face while ears are cut off.
class Ears {
  public:
    explicit Ears(const Outline& face)
        : face_(face), side_(turn(face)), boxes_(face), before_(face.size()), after_(face.size()) {
        for (std::size_t i = 0; i < face.size(); ++i) {
            before_[i] = (i == 0 ? face.size() : i) - 1;
            after_[before_[i]] = i;
            unknown_.insert(unknown_.end(), i);
        }
    }

    /// The triangles, or none where no ear is found.
    std::optional<std::vector<glm::uvec3>> cut() {
        std::vector<glm::uvec3> triangles;
        while (triangles.size() + 2 < face_.size()) {
            const std::optional<std::size_t> ear = next_ear();
            if (!ear) return std::nullopt;
            triangles.emplace_back(face_[before_[*ear]].vertex, face_[*ear].vertex,
                                   face_[after_[*ear]].vertex);
            cut_off(*ear);
        }
        return triangles;
    }

  private:
    enum class Kind {
        ear,
        straight,  ///< between its neighbours' edges is no area
        neither,   ///< remains so until a neighbour is cut off: what is left only shrinks
    };

    /// The first ear; where there is none, the first corner without area.
    std::optional<std::size_t> next_ear() {
        while (!unknown_.empty()) {
            const std::size_t i = *unknown_.begin();
            unknown_.erase(unknown_.begin());
            const Kind kind = kind_of(i);
            if (kind == Kind::ear) return i;
            if (kind == Kind::straight) straight_.insert(i);
        }
        return straight_.empty() ? std::nullopt : std::optional(*straight_.begin());
    }

    Kind kind_of(std::size_t i) const {
        const glm::dvec2 &a = face_[before_[i]].p, &b = face_[i].p, &c = face_[after_[i]].p;
        const int turned = turn(a, b, c);
        if (turned == 0) return Kind::straight;
        if (turned != side_) return Kind::neither;
        const Triangle triangle{a, b, c, side_};
        return boxes_.any([&](const Box& box) { return triangle.may_hold(box); }) ? Kind::neither : Kind::ear;
    }

    void cut_off(std::size_t i) {
        straight_.erase(i);
        boxes_.remove(i);
        after_[before_[i]] = after_[i];
        before_[after_[i]] = before_[i];
        for (const std::size_t neighbour : {before_[i], after_[i]}) {
            straight_.erase(neighbour);
            unknown_.insert(neighbour);
        }
    }

    const Outline& face_;
    int side_;
    CornerBoxes boxes_;
    std::vector<std::size_t> before_, after_;   ///< neighbours among the corners that are left
    std::set<std::size_t> unknown_, straight_;  ///< corners that are left; all others are neither
};

}  // namespace

void cut_concave_faces(std::span<const TriangleRun> faces, Scene& scene) {
    std::uint64_t tests = limits::ear_tests, overlapping = 0;
    for (const auto& [first, count] : faces) {
        if (count < 2) continue;
        const std::span<glm::uvec3> triangles = std::span(scene.triangles).subspan(first, count);
        const Outline face = outline_of(triangles, scene.vertices.position_world);
        if (is_covered_by_fan(face)) continue;
        const std::uint64_t needed = std::uint64_t{count} * count;
        const auto cut = needed <= tests ? Ears(face).cut() : std::nullopt;
        tests -= std::min(tests, needed);
        overlapping += !cut;
        if (cut) std::ranges::copy(*cut, triangles.begin());
    }
    note_count(scene, overlapping,
               "concave faces that cross themselves or are too large, left as fans that overlap");
}

}  // namespace zproof
