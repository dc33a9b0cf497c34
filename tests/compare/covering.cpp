/// Is a bounded convex set covered by closed convex sets? What they leave is open in it, so it holds a whole
/// cell of the lines' arrangement: one point of each cell is asked.
#include <algorithm>

#include "brute_force.h"

namespace zproof::brute_force {

namespace {

struct Point {
    Rational x, y;
    bool operator==(const Point&) const = default;
};

using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Of an integer functional (see `in_integers`): without a fraction to be reduced.
int side(const Functional& f, const Point& p) {
    const Integer x = numerator(p.x) * denominator(p.y), y = numerator(p.y) * denominator(p.x);
    const Integer d = denominator(p.x) * denominator(p.y);
    return (numerator(f.a) * x + numerator(f.b) * y + numerator(f.c) * d).sign();
}

Functional in_integers(const Functional& f) {
    const Rational scale(Integer(denominator(f.a) * denominator(f.b) * denominator(f.c)));
    const Rational a = scale * f.a, b = scale * f.b, c = scale * f.c;
    const Rational common(Integer(gcd(gcd(numerator(a), numerator(b)), numerator(c))));
    return common == 0 ? f : Functional{a / common, b / common, c / common};
}
Set in_integers(const Set& set) {
    Set integers;
    for (const Functional& f : set) integers.push_back(in_integers(f));
    return integers;
}

bool is_in(const Set& set, const Point& p) {
    return std::ranges::all_of(set, [&](const Functional& f) { return side(f, p) >= 0; });
}
bool is_in_any(const std::vector<Set>& sets, const Point& p) {
    return std::ranges::any_of(sets, [&](const Set& set) { return is_in(set, p); });
}

std::optional<Point> crossing(const Functional& f, const Functional& g) {
    const Rational d = f.a * g.b - f.b * g.a;
    if (d == 0) return std::nullopt;
    return Point{(f.b * g.c - f.c * g.b) / d, (f.c * g.a - f.a * g.c) / d};
}

/// A number between two others with as few binary digits as may be.
Rational short_number_between(const Rational& low, const Rational& high) {
    for (unsigned bits = 0;; bits = 2 * bits + 1) {
        const Integer scaled = numerator(low) << bits, d = denominator(low);
        Integer whole = scaled / d;
        if (whole * d > scaled) --whole;
        const Rational next(Integer(whole + 1), Integer(Integer(1) << bits));
        if (next < high) return next;
    }
}

void sort_and_merge(std::vector<Rational>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::vector<Rational> gaps(std::vector<Rational> numbers) {
    sort_and_merge(numbers);
    std::vector<Rational> between;
    for (std::size_t i = 0; i + 1 < numbers.size(); ++i)
        between.push_back(short_number_between(numbers[i], numbers[i + 1]));
    return between;
}

/// The corners of a bounded convex set.
std::vector<Point> corners_of(const Set& set) {
    std::vector<Point> corners;
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto p = crossing(set[i], set[j]);
            if (p && is_in(set, *p) && std::ranges::count(corners, *p) == 0) corners.push_back(*p);
        }
    return corners;
}

bool is_segment(const std::vector<Point>& corners) {
    const Point &a = corners[0], &b = corners[1];
    return std::ranges::all_of(
        corners, [&](const Point& c) { return (b.x - a.x) * (c.y - a.y) == (b.y - a.y) * (c.x - a.x); });
}

bool segment_is_covered(const std::vector<Point>& corners, const std::vector<Set>& sets) {
    const auto by_place = [](const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; };
    const auto [a, b] = std::ranges::minmax(corners, by_place);
    std::vector<Rational> parts{0, 1};
    for (const Set& set : sets)
        for (const Functional& f : set)
            if (side(f, a) * side(f, b) < 0) {
                const Rational at_a = f.a * a.x + f.b * a.y + f.c, at_b = f.a * b.x + f.b * b.y + f.c;
                parts.push_back(at_a / (at_a - at_b));
            }
    const auto covers = [&, from = a, to = b](const Rational& t) {
        return is_in_any(sets, {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    };
    return std::ranges::all_of(gaps(parts), covers);
}

/// The lines that part the polygon with these corners.
Set parting_lines(const std::vector<Point>& corners, const std::vector<Set>& sets) {
    Set lines;
    for (const Set& set : sets)
        for (const Functional& f : set) {
            const auto at = [&](int s) {
                return std::ranges::any_of(corners, [&](const Point& c) { return side(f, c) == s; });
            };
            if (at(-1) && at(1)) lines.push_back(f);
        }
    return lines;
}

bool polygon_is_covered(const Set& place, const std::vector<Point>& corners, const std::vector<Set>& sets) {
    Set lines = parting_lines(corners, sets);
    lines.insert(lines.end(), place.begin(), place.end());
    std::vector<Rational> xs;
    for (const Point& p : corners) xs.push_back(p.x);
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (const auto p = crossing(lines[i], lines[j]); p && is_in(place, *p)) xs.push_back(p->x);
    for (const Rational& x : gaps(xs)) {
        std::vector<Rational> ys;
        for (const Functional& f : lines)
            if (f.b != 0)
                if (const Point p{x, -(f.a * x + f.c) / f.b}; is_in(place, p)) ys.push_back(p.y);
        for (const Rational& y : gaps(ys))
            if (!is_in_any(sets, {x, y})) return false;
    }
    return true;
}

}  // namespace

bool is_empty(const Set& place) { return corners_of(in_integers(place)).empty(); }

bool is_covered(const Set& place, const std::vector<Set>& sets) {
    const Set within = in_integers(place);
    std::vector<Set> covers;
    for (const Set& set : sets) covers.push_back(in_integers(set));
    const std::vector<Point> corners = corners_of(within);
    if (corners.empty()) return true;
    if (corners.size() == 1) return is_in_any(covers, corners[0]);
    if (is_segment(corners)) return segment_is_covered(corners, covers);
    return polygon_is_covered(within, corners, covers);
}

}  // namespace zproof::brute_force
