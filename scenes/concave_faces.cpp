#include "scenes/concave_faces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
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
int exact_turn(const auto&... outline) {
    try {
        return sign(doubled_area<Interval>(outline...));
    } catch (const UndecidedSign&) {
        return sign(doubled_area<Rational>(outline...));
    }
}

/// The sign of a triangle's area where double tells it for certain, else 0 (Shewchuk, Discrete and
/// Computational Geometry 18, 1997: the error bound A of ORIENT2D). Products of float32's differences do not
/// underflow.
int certain_turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    constexpr double u = 0x1p-53, error = (3 + 16 * u) * u;
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
    const double area = left - right, bound = error * (std::abs(left) + std::abs(right));
    return int(area > bound) - int(area < -bound);
}

int turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const int certain = certain_turn(a, b, c);
    return certain != 0 ? certain : exact_turn(a, b, c);
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

/// A closed triangle that turns as `side` says.
struct Triangle {
    glm::dvec2 a, b, c;
    int side;
    Box box = around({glm::min(a, b), glm::max(a, b)}, {c, c});

    /// Is the point inside, and no corner?
    bool holds(const glm::dvec2& p) const {
        const bool is_in_box = p.x >= box.low.x && p.y >= box.low.y && p.x <= box.high.x && p.y <= box.high.y;
        return is_in_box && p != a && p != b && p != c && turn(c, a, p) * side >= 0 &&
               turn(a, b, p) * side >= 0 && turn(b, c, p) * side >= 0;
    }

    /// False only where they do not meet for certain.
    bool may_meet(const Box& other) const {
        return !glm::any(glm::lessThan(box.high, other.low)) &&
               !glm::any(glm::lessThan(other.high, box.low)) && !lies_beyond(a, b, other) &&
               !lies_beyond(b, c, other) && !lies_beyond(c, a, other);
    }

  private:
    /// Is the box's innermost corner certainly on the edge's outer side?
    bool lies_beyond(const glm::dvec2& from, const glm::dvec2& to, const Box& other) const {
        const bool is_low_x = (to.y > from.y) == (side > 0), is_low_y = (to.x < from.x) == (side > 0);
        const glm::dvec2 innermost{(is_low_x ? other.low : other.high).x,
                                   (is_low_y ? other.low : other.high).y};
        return certain_turn(from, to, innermost) * side < 0;
    }
};

/// The corners that are left, in a binary tree of boxes: halves by x and y in turn.
class CornerTree {
  public:
    explicit CornerTree(const Outline& face)
        : leaves_(std::bit_ceil((face.size() + most - 1) / most)), place_(face.size()), boxes_(2 * leaves_) {
        std::vector<std::size_t> corners(face.size());
        std::iota(corners.begin(), corners.end(), std::size_t{0});
        halve(face, corners, leaves_, 0);
        for (const std::size_t corner : corners) {
            place_[corner] = points_.size();
            points_.push_back(face[corner].p);
        }
        for (std::size_t node = 2 * leaves_; --node > 0;) measure(node);
    }

    void remove(std::size_t corner) {
        points_[place_[corner]] = glm::dvec2(std::numeric_limits<double>::quiet_NaN());
        for (std::size_t node = leaves_ + place_[corner] / most; node > 0; node /= 2) measure(node);
    }

    /// Does the triangle hold a point that is none of its corners?
    bool has_one_in(const Triangle& triangle, std::size_t node = 1) const {
        if (!triangle.may_meet(boxes_[node])) return false;
        if (node < leaves_) return has_one_in(triangle, 2 * node) || has_one_in(triangle, 2 * node + 1);
        return std::ranges::any_of(points_in(node), [&](const glm::dvec2& p) { return triangle.holds(p); });
    }

  private:
    static constexpr std::size_t most = 16;  ///< points in a leaf

    /// Puts the corners into the order of their leaves, of which there are so many.
    static void halve(const Outline& face, std::span<std::size_t> corners, std::size_t leaves, int axis) {
        const std::size_t half = leaves / 2;
        if (half == 0) return;
        if (corners.size() > half * most) {
            std::ranges::nth_element(corners, corners.begin() + std::ptrdiff_t(half * most), {},
                                     [&](std::size_t corner) { return face[corner].p[axis]; });
            halve(face, corners.subspan(half * most), half, 1 - axis);
        }
        halve(face, corners.first(std::min(half * most, corners.size())), half, 1 - axis);
    }

    std::span<const glm::dvec2> points_in(std::size_t leaf) const {
        const std::size_t first = std::min((leaf - leaves_) * most, points_.size());
        return std::span(points_).subspan(first, std::min(most, points_.size() - first));
    }

    void measure(std::size_t node) {
        if (node < leaves_) {
            boxes_[node] = around(boxes_[2 * node], boxes_[2 * node + 1]);
            return;
        }
        boxes_[node] = {};
        for (const glm::dvec2& p : points_in(node))
            if (p == p) boxes_[node] = around(boxes_[node], {p, p});
    }

    std::size_t leaves_;
    std::vector<std::size_t> place_;  ///< among the points, by corner
    std::vector<glm::dvec2> points_;  ///< leaf by leaf; NaN where it was removed
    std::vector<Box> boxes_;          ///< those within boxes_[i] are 2 i and 2 i + 1
};

/// What is left of a face while ears are cut off.
class Ears {
  public:
    explicit Ears(const Outline& face)
        : face_(face),
          side_(exact_turn(face)),
          left_(face),
          before_(face.size()),
          after_(face.size()),
          kinds_(face.size(), Kind::unknown) {
        for (std::size_t i = 0; i < face.size(); ++i) {
            before_[i] = (i == 0 ? face.size() : i) - 1;
            after_[before_[i]] = i;
            unknown_.push(i);
        }
    }

    /// The triangles, or none where no ear is found.
    std::optional<std::vector<glm::uvec3>> cut() {
        std::vector<glm::uvec3> triangles;
        while (triangles.size() + 2 < face_.size()) {
            const std::size_t i = next_ear();
            if (i == face_.size()) return std::nullopt;
            triangles.emplace_back(face_[before_[i]].vertex, face_[i].vertex, face_[after_[i]].vertex);
            cut_off(i);
        }
        return triangles;
    }

  private:
    enum class Kind : std::uint8_t {
        unknown,
        ear,
        straight,  ///< between its neighbours' edges is no area
        neither,   ///< remains so until a neighbour is cut off: what is left only shrinks
        gone,
    };

    /// The first ear; where there is none, the first corner without area.
    std::size_t next_ear() {
        while (!unknown_.empty()) {
            const std::size_t i = unknown_.top();
            unknown_.pop();
            if (kinds_[i] != Kind::unknown) continue;
            kinds_[i] = kind_of(i);
            if (kinds_[i] == Kind::ear) return i;
        }
        return std::size_t(std::ranges::find(kinds_, Kind::straight) - kinds_.begin());
    }

    Kind kind_of(std::size_t i) const {
        const glm::dvec2 &a = face_[before_[i]].p, &b = face_[i].p, &c = face_[after_[i]].p;
        const int turned = turn(a, b, c);
        if (turned == 0) return Kind::straight;
        return turned != side_ || left_.has_one_in(Triangle{a, b, c, side_}) ? Kind::neither : Kind::ear;
    }

    void cut_off(std::size_t i) {
        left_.remove(i);
        kinds_[i] = Kind::gone;
        after_[before_[i]] = after_[i];
        before_[after_[i]] = before_[i];
        for (const std::size_t neighbour : {before_[i], after_[i]}) {
            kinds_[neighbour] = Kind::unknown;
            unknown_.push(neighbour);
        }
    }

    const Outline& face_;
    int side_;
    CornerTree left_;
    std::vector<std::size_t> before_, after_;  ///< neighbours among the corners that are left
    std::vector<Kind> kinds_;
    /// Corners whose kind is unknown, the first on top, and some that have one by now.
    std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> unknown_;
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
