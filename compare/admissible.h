/// The admissible set at one pixel: which answers a faultless renderer may give there (docs/truth.md).
#pragma once

#include <deque>
#include <map>
#include <optional>

#include "compare/edge_on.h"
#include "compare/neighbourhood.h"
#include "compare/region.h"

namespace zproof {

enum class DepthRule {
    bounded,  ///< an occluder hides only what it is in front of by more than both depth bounds
    strict,   ///< an occluder hides whatever is not strictly nearer; ties included
};
enum class EdgeRule {
    as_is,
    unshared_moved_inwards,  ///< occluders' edges that no other occluder shares are moved inwards by eps
};
struct Rules {
    DepthRule depth = DepthRule::bounded;
    EdgeRule edges = EdgeRule::as_is;
};

/// Decides by the signs of Number; with Interval, throws UndecidedSign where double precision is not enough.
template <class Number>
class AdmissibleSet {
  public:
    explicit AdmissibleSet(const Neighbourhood& neighbourhood);

    /// Is the triangle (an index into neighbours) visible somewhere in the square?
    bool holds(size_t index, Rules rules);
    /// Is some point of the square not covered by any triangle?
    bool holds_background(EdgeRule edges);
    /// Does the triangle, between near and far, meet the square at all?
    bool reaches(size_t index) { return !seen_pieces(index).empty(); }
    /// Does the near or far plane cut the triangle within the square?
    bool is_clipped(size_t index);

  private:
    using LinePointer = const Line<Number>*;
    /// A convex part of a candidate as it appears in the square, with the nearness that holds on it.
    struct Piece {
        Region<Number> region;
        Affine<Number> nearness;
        size_t index;
    };
    /// A triangle's image; no image where it is seen edge-on.
    struct Drawn {
        std::optional<TriangleImage<Number>> image;
        std::array<LinePointer, 3> edge{};
    };
    enum class Side { near, far };
    enum class Slack { admit, require };

    LinePointer new_line(const Affine<Number>& f);
    LinePointer edge_line(const Affine<Number>& f, const CornersWorld& p_world, size_t edge);
    int corner_id(const glm::vec3& p_world);
    Drawn draw(const Neighbour& neighbour);
    Region<Number> square();

    std::optional<LinePointer> plane(Side side, const Affine<Number>& nearness, const Neighbour& n, Slack slack);
    void push_clipped(std::vector<Piece>& pieces, std::optional<Region<Number>> region,
                      const Affine<Number>& nearness, size_t index);
    std::vector<Piece> seen_pieces(size_t index);
    std::vector<Piece> edge_on_pieces(size_t index);
    bool is_shared(LinePointer edge) const { return edge_count_.at(edge->id) > 1; }
    LinePointer covering_edge(LinePointer edge, EdgeRule rule);
    HalfPlanes<Number> covering(size_t index, EdgeRule rule);
    Affine<Number> lead(size_t occluder, const Piece& seen, DepthRule rule);
    bool visible(const Piece& piece, Rules rules);

    const Neighbourhood& around_;
    Sight<Number> sight_;
    std::deque<Line<Number>> lines_;  ///< regions point at lines: all live as long as the set
    std::array<LinePointer, 4> sides_{};
    std::vector<glm::vec3> corner_positions_;
    std::map<std::pair<int, int>, int> edge_ids_;
    std::map<int, int> edge_count_;  ///< triangles per edge id
    std::vector<Drawn> drawn_;
};

}  // namespace zproof
