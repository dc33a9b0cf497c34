#include "filters/area/visible.h"

#include <algorithm>
#include <cmath>

namespace zproof::oracle::area {

namespace {

/// The limits beyond which samples are cheaper.
constexpr std::size_t most_triangles = 32, most_pieces = 128, most_cut_corners = most_corners - 16;

using Polygons = std::vector<Polygon<double>>;

/// A triangle around one pixel, with the half-planes f >= 0 that bound its image.
struct Candidate {
    std::uint32_t triangle = 0;
    Affine<double> inverse_depth{};
    std::array<Affine<double>, 5> bounds{};
    Polygon<double> image{};  ///< within the square
};

/// f at a corner of a polygon within the square is known to no better than this: four roundings of the value,
/// and two of each coordinate.
double rounding(const Affine<double>& f, double half_side) {
    return 8 * 0x1p-53 * (half_side * (std::abs(f.a) + std::abs(f.b)) + std::abs(f.c));
}

/// Takes the common part of half-planes away from polygons, piece by piece.
class Subtraction {
  public:
    explicit Subtraction(double half_side) : half_side_(half_side) {}

    Polygons operator()(const Polygons& polygons, std::span<const Affine<double>> hiding) const {
        Polygons left;
        for (const Polygon<double>& polygon : polygons) subtract(polygon, hiding, left);
        return left;
    }

  private:
    bool reaches(const Polygon<double>& polygon, const Affine<double>& f) const {
        const double margin = rounding(f, half_side_);
        return std::ranges::any_of(polygon, [&](const auto& p) { return f.at(p.x, p.y) > margin; });
    }

    void subtract(const Polygon<double>& polygon, std::span<const Affine<double>> hiding,
                  Polygons& left) const {
        if (std::ranges::any_of(hiding, [&](const auto& f) { return !reaches(polygon, f); })) {
            left.push_back(polygon);
            return;
        }
        Polygon<double> rest = polygon;
        for (const Affine<double>& f : hiding) {
            if (!reaches(rest, -f)) continue;
            const Halves<double> halves = cut(rest, f);
            if (halves.outside.size() > 2) left.push_back(halves.outside);
            rest = halves.inside;
        }
    }

    double half_side_;
};

Candidate candidate(const Surfaces& surfaces, std::uint32_t id, const Point<double>& centre,
                    double half_side) {
    const SeenTriangle<double>& t = *surfaces.seen(id);
    const auto here = [&](const Affine<double>& f) { return from(f, centre.x, centre.y); };
    const auto [nearest, farthest] = surfaces.range();
    Candidate c{.triangle = id, .inverse_depth = here(t.inverse_depth)};
    c.bounds = {here(t.edge[0]), here(t.edge[1]), here(t.edge[2]),
                c.inverse_depth - Affine<double>{0, 0, farthest},
                Affine<double>{0, 0, nearest} - c.inverse_depth};
    c.image = square(half_side);
    for (const Affine<double>& bound : c.bounds) c.image = cut(c.image, bound).inside;
    return c;
}

bool is_too_much(const Polygons& polygons) {
    return polygons.size() > most_pieces ||
           std::ranges::any_of(polygons, [](const auto& p) { return p.size() > most_cut_corners; });
}

/// The part of `subject` that `other` hides: where it stands nearer, of equally near ones the first.
std::array<Affine<double>, 6> hidden_part(const Candidate& subject, const Candidate& other) {
    Affine<double> nearer = other.inverse_depth - subject.inverse_depth;
    if (nearer.a == 0 && nearer.b == 0 && nearer.c == 0)
        nearer.c = other.triangle < subject.triangle ? 1 : -1;
    const auto& b = other.bounds;
    return {nearer, b[0], b[1], b[2], b[3], b[4]};
}

std::optional<Polygons> seen_of(const Candidate& subject, std::span<const Candidate> all,
                                const Subtraction& without) {
    Polygons polygons{subject.image};
    for (const Candidate& other : all) {
        if (other.triangle == subject.triangle) continue;
        polygons = without(polygons, hidden_part(subject, other));
        if (is_too_much(polygons)) return std::nullopt;
    }
    return polygons;
}

std::optional<bool> covers(std::span<const Candidate> all, const Subtraction& without, double half_side) {
    Polygons gap{square(half_side)};
    for (const Candidate& c : all) {
        gap = without(gap, c.bounds);
        if (is_too_much(gap)) return std::nullopt;
    }
    return gap.empty();
}

}  // namespace

std::optional<Visible> visible_pieces(const Surfaces& surfaces, std::span<const std::uint32_t> candidates,
                                      const Point<double>& centre, double half_side) {
    if (candidates.size() > most_triangles) return std::nullopt;
    std::vector<Candidate> all;
    for (const std::uint32_t id : candidates)
        if (Candidate c = candidate(surfaces, id, centre, half_side); c.image.size() > 2)
            all.push_back(std::move(c));
    const Subtraction without(half_side);
    Visible visible;
    for (const Candidate& subject : all) {
        const auto polygons = seen_of(subject, all, without);
        if (!polygons) return std::nullopt;
        for (const Polygon<double>& p : *polygons) visible.pieces.push_back({subject.triangle, p});
    }
    const std::optional<bool> covered = covers(all, without, half_side);
    if (!covered || visible.pieces.size() > most_pieces) return std::nullopt;
    visible.covers = *covered;
    return visible;
}

void Sight::add(const Visible& visible) {
    covers = covers && visible.covers;
    for (const Piece& p : visible.pieces)
        if (triangles.empty() || triangles.back() != p.triangle) triangles.push_back(p.triangle);
}

void Sight::add(const Sight& other) {
    covers = covers && other.covers;
    for (const std::uint32_t triangle : other.triangles)
        if (triangles.empty() || triangles.back() != triangle) triangles.push_back(triangle);
}

bool is_one_surface(const Surfaces& surfaces, const Sight& sight) {
    std::vector<std::uint32_t> apart(sight.triangles.begin(), sight.triangles.end()), linked;
    std::ranges::sort(apart);
    apart.erase(std::ranges::unique(apart).begin(), apart.end());
    for (const std::uint32_t triangle : apart)
        if (surfaces.material(triangle) != surfaces.material(apart[0])) return false;
    linked.assign(1, apart.back());
    apart.pop_back();
    for (std::size_t next = 0; next < linked.size(); ++next) {
        const auto joined = std::partition(apart.begin(), apart.end(), [&](std::uint32_t id) {
            return !surfaces.share_an_edge(id, linked[next]);
        });
        linked.insert(linked.end(), joined, apart.end());
        apart.erase(joined, apart.end());
    }
    return apart.empty();
}

}  // namespace zproof::oracle::area
