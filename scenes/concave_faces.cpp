#include "scenes/concave_faces.h"

#include <algorithm>
#include <optional>
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

/// What is left of a face while ears are cut off.
class Ears {
  public:
    explicit Ears(Outline face)
        : left_(std::move(face)), side_(turn(left_)), kinds_(left_.size(), Kind::unknown) {}

    /// The triangles, or none where no ear is found.
    std::optional<std::vector<glm::uvec3>> cut() {
        std::vector<glm::uvec3> triangles;
        while (left_.size() > 2) {
            const std::size_t i = next_ear();
            if (i == left_.size()) return std::nullopt;
            triangles.emplace_back(left_[before(i)].vertex, left_[i].vertex, left_[after(i)].vertex);
            kinds_[before(i)] = kinds_[after(i)] = Kind::unknown;
            left_.erase(left_.begin() + std::ptrdiff_t(i));
            kinds_.erase(kinds_.begin() + std::ptrdiff_t(i));
        }
        return triangles;
    }

  private:
    enum class Kind : std::uint8_t {
        unknown,
        ear,
        straight,  ///< between its neighbours' edges is no area
        neither,   ///< remains so until a neighbour is cut off: what is left only shrinks
    };

    std::size_t before(std::size_t i) const { return (i == 0 ? left_.size() : i) - 1; }
    std::size_t after(std::size_t i) const { return i + 1 == left_.size() ? 0 : i + 1; }

    /// The first ear; where there is none, the first corner without area.
    std::size_t next_ear() {
        for (std::size_t i = 0; i < left_.size(); ++i) {
            if (kinds_[i] == Kind::unknown) kinds_[i] = kind_of(i);
            if (kinds_[i] == Kind::ear) return i;
        }
        return std::size_t(std::ranges::find(kinds_, Kind::straight) - kinds_.begin());
    }

    Kind kind_of(std::size_t i) const {
        const glm::dvec2 &a = left_[before(i)].p, &b = left_[i].p, &c = left_[after(i)].p;
        const int turned = turn(a, b, c);
        if (turned == 0) return Kind::straight;
        const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        const auto is_in_the_way = [&](const Corner& corner) {
            const glm::dvec2& p = corner.p;
            if (p.x < low.x || p.y < low.y || p.x > high.x || p.y > high.y) return false;
            return p != a && p != b && p != c && turn(c, a, p) * side_ >= 0 && turn(a, b, p) * side_ >= 0 &&
                   turn(b, c, p) * side_ >= 0;
        };
        return turned != side_ || std::ranges::any_of(left_, is_in_the_way) ? Kind::neither : Kind::ear;
    }

    Outline left_;
    int side_;
    std::vector<Kind> kinds_;  ///< of the corners that are left
};

}  // namespace

void cut_concave_faces(std::span<const TriangleRun> faces, Scene& scene) {
    std::uint64_t tests = limits::ear_tests, overlapping = 0;
    for (const auto& [first, count] : faces) {
        if (count < 2) continue;
        const std::span<glm::uvec3> triangles = std::span(scene.triangles).subspan(first, count);
        Outline face = outline_of(triangles, scene.vertices.position_world);
        if (is_covered_by_fan(face)) continue;
        const std::uint64_t needed = std::uint64_t{count} * count;
        const auto cut = needed <= tests ? Ears(std::move(face)).cut() : std::nullopt;
        tests -= std::min(tests, needed);
        overlapping += !cut;
        if (cut) std::ranges::copy(*cut, triangles.begin());
    }
    note_count(scene, overlapping,
               "concave faces that cross themselves or are too large, left as fans that overlap");
}

}  // namespace zproof
