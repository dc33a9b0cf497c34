/// The admissible set once more, slow and plain, all in exact numbers: corners are projected by solving for
/// their place in the image, and whether closed sets cover a place is asked of one point in every cell into
/// which their lines cut it.
#pragma once

#include <optional>

#include "compare/admissible/admissible_set.h"
#include "math/rational.h"

namespace zproof::brute_force {

/// A x + B y + C, homogeneous: at a place (X, Y, D) of the image, x = X / D, its sign is that of A X + B Y +
/// C D.
struct Functional {
    Rational a, b, c;
};
/// D is 1 or camera depth.
struct ImagePoint {
    Rational x, y, d;
};
/// A corner in the image: the place, and the distance along the view ray.
struct Corner {
    ImagePoint at;
    Rational depth;
};

/// A closed set: where all are >= 0.
using Set = std::vector<Functional>;

/// Is every point of the closed set `place` (bounded) in one of the closed sets? True where `place` is empty.
bool is_covered(const Set& place, const std::vector<Set>& sets);
bool is_empty(const Set& place);

class Picture {
  public:
    explicit Picture(const Neighbourhood& around);

    bool reaches(std::size_t index) const;
    bool is_visible(std::size_t index) const;
    bool is_inside_by_rounding(std::size_t index) const;
    bool is_clipped(std::size_t index) const;
    bool holds(std::size_t index, Rules rules) const;
    bool holds_background(EdgeRule rule) const;

  private:
    struct Triangle {
        std::array<Corner, 3> corner;
        int orientation = 0;             ///< 0: edge-on
        std::array<Functional, 3> edge;  ///< >= 0 inside
        Functional inverse_depth;
    };
    enum class Plane { as_far_as_it_may_be, as_near_as_it_may_be };

    Triangle draw(const Neighbour& n) const;
    Set square() const;
    Set clip_planes(std::size_t index, const Functional& inverse_depth, Plane plane) const;
    Set outline(std::size_t index) const;
    std::optional<int> side_of(std::size_t index, std::size_t edge, std::size_t other) const;
    bool is_in_front(std::size_t occluder, std::size_t seen, DepthRule rule) const;
    std::vector<std::size_t> in_front_of(std::size_t seen, DepthRule rule) const;
    Set cover(std::size_t occluder, std::optional<std::size_t> seen) const;
    bool may_part(std::size_t occluder, const std::vector<std::size_t>& occluders,
                  std::optional<std::size_t> seen) const;
    std::vector<std::size_t> sheet_of(std::vector<std::size_t> occluders,
                                      std::optional<std::size_t> seen) const;
    bool leaves_bare(const std::vector<std::size_t>& occluders, EdgeRule rule,
                     std::optional<std::size_t> seen) const;

    const Neighbourhood& around_;
    bool perspective_;
    std::vector<Triangle> triangles_;
};

}  // namespace zproof::brute_force
