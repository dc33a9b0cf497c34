/// The admissible set at one pixel: which answers a faultless renderer may give there (docs/truth.md).
#pragma once

#include <deque>
#include <map>
#include <optional>

#include "compare/admissible/coplanar.h"
#include "compare/admissible/edge_on.h"
#include "compare/admissible/neighbourhood.h"
#include "compare/admissible/region.h"

namespace zproof {

enum class DepthRule {
    bounded,  ///< an occluder hides only what it is in front of by more than both depth bounds
    strict,   ///< an occluder hides whatever is not strictly nearer; ties included
};
enum class EdgeRule {
    watertight,  ///< occluders move together: only the outline of their union moves
    separate,    ///< occluders part along edges that no other continues: only a sheet without them covers
    apart,       ///< every occluder moves by itself: none holds the centre with all its edges inwards by eps
};
struct Rules {
    DepthRule depth = DepthRule::bounded;
    EdgeRule edges = EdgeRule::watertight;
};

/// Thrown where a decision would take more than Neighbourhood::most_work: work per pixel is bounded. It is
/// counted in cuts of a region by a half-plane.
struct TooMuchWork {};

/// Decides by the signs of Number: exactly with rationals; with Interval, throws UndecidedSign where double
/// precision is not enough. With double, an estimate. Throws TooMuchWork.
template <class Number>
class AdmissibleSet {
  public:
    /// The neighbourhood and the cache must outlive the set.
    AdmissibleSet(const Neighbourhood& neighbourhood);

    /// What its answers took so far, in cuts of a region by a half-plane.
    std::size_t work() const { return work_; }

    /// Another half-side than the neighbourhood's eps_px, from here on.
    void set_half_side(double half_side_px);

    /// Is the triangle (an index into neighbours) truly visible somewhere in the square?
    bool is_visible(size_t index);
    /// Can it be answered by a renderer that moves corners by up to eps: does it meet the square, and is the
    /// square not wholly covered by triangles in front of it? Edges that it shares with an occluder move
    /// together: one that both have on the same side does not bound the occluder, and beyond one with each on
    /// its own side there is none.
    bool holds(size_t index, Rules rules);
    /// Does it need nothing but its place: would it be held if depths were exact, or is it truly visible?
    bool is_seen(size_t index) { return holds(index, {DepthRule::strict, edge_rule()}) || is_visible(index); }
    /// How the renderer moves occluders.
    EdgeRule edge_rule() const { return around_.is_watertight ? EdgeRule::watertight : EdgeRule::apart; }
    /// Is some point of the square not covered by any triangle?
    bool holds_background(EdgeRule edges);
    /// Does the triangle, between near and far, meet the square at all?
    bool reaches(size_t index) { return !seen_pieces(index).empty(); }
    /// Does it reach the square, or do its edge functions, rounded one by one, all say that it holds the
    /// centre?
    bool is_shown(size_t index) {
        return reaches(index) || (half_side_px_ == around_.eps_px && is_inside_by_rounding(index));
    }
    /// Does the near or far plane cut the triangle within the square?
    bool is_clipped(size_t index);

  private:
    using LinePointer = const Line<Number>*;
    /// A convex part of a candidate as it appears in the square, with the inverse depth that holds on it.
    struct Piece {
        Region<Number> region;
        Affine<Number> inverse_depth;
        size_t index;
    };
    /// A triangle's image; no image where it is seen edge-on.
    struct NeighbourImage {
        std::optional<TriangleImage<Number>> image;
        std::array<LinePointer, 3> edge{};
    };
    enum class ClipSide { near, far };
    enum class Slack { admit, require };

    /// Does the renderer draw it for certain, with an image?
    bool may_occlude(size_t index) {
        return !around_.neighbours[index].may_be_missing && drawn(index).image.has_value();
    }
    LinePointer new_line(const Affine<Number>& f);
    /// The other side of the same line.
    LinePointer reversed(LinePointer line);
    LinePointer edge_line(const Affine<Number>& f, const CornersWorld& p_world, size_t edge);
    int locus_of(const glm::vec3& from_world, const glm::vec3& to_world, const Slope& slope);
    NeighbourImage draw(const Neighbour& neighbour);
    Region<Number> square();
    std::array<LinePointer, 4> sides_of_square(double half_side_px);
    bool is_inside_by_rounding(size_t index);

    std::optional<LinePointer> plane(ClipSide side, const Affine<Number>& inverse_depth, const Neighbour& n,
                                     Slack slack);
    void push_clipped(std::vector<Piece>& pieces, std::optional<Region<Number>> region,
                      const Affine<Number>& inverse_depth, size_t index);
    /// The pieces are made when they are first asked for.
    const std::vector<Piece>& seen_pieces(size_t index);
    std::vector<Piece> pieces_inside(size_t index);
    std::vector<Piece> edge_on_pieces(size_t index);
    std::optional<Region<Number>> inside(const SegmentImage<Number>& segment);
    void push_near_cut(std::vector<Piece>& pieces, const std::vector<SegmentImage<Number>>& edges,
                       size_t index);
    /// The image is drawn when it is first asked for: most occluders are never reached.
    const NeighbourImage& drawn(size_t index);
    LinePointer edge_of(size_t index, int edge_id);
    std::optional<bool> are_on_one_side(LinePointer edge, size_t other);
    bool continues(LinePointer edge, const std::vector<size_t>& occluders);
    bool may_part(size_t occluder, std::optional<size_t> seen, const std::vector<size_t>& occluders);
    template <class Occludes>
    std::vector<size_t> watertight_sheet(std::optional<size_t> seen, const Occludes& occludes);
    LinePointer moved_inwards(LinePointer edge);
    bool stands_apart(size_t occluder, size_t seen);
    bool meet_at_the_centre(size_t occluder, size_t seen);

    bool is_in_front(size_t occluder, size_t seen, DepthRule rule);
    void push_planes(HalfPlanes<Number>& half_planes, size_t occluder);
    LinePointer nearer_side(size_t occluder, const Piece& seen);
    std::optional<HalfPlanes<Number>> true_cover(size_t occluder, const Piece& seen);
    enum class EdgeStays { yes, no };
    HalfPlanes<Number> cover(size_t occluder, std::optional<size_t> seen, EdgeStays stays);
    template <class Occludes>
    std::optional<std::vector<size_t>> covered_by(std::optional<size_t> seen, const Occludes& occludes);
    bool holds_centre(size_t occluder, std::optional<size_t> seen);
    bool is_cut_at_the_centre(size_t occluder);
    template <class Occludes>
    bool leaves_bare(std::optional<size_t> seen, const Occludes& occludes);
    template <class Occludes>
    bool leaves_bare_by(EdgeRule rule, std::optional<size_t> seen, const Occludes& occludes);

    void spend(std::size_t work);
    std::vector<Region<Number>> left_of(const std::vector<Region<Number>>& regions,
                                        const HalfPlanes<Number>& half_planes);

    const Neighbourhood& around_;
    std::size_t work_ = 0;
    double half_side_px_;
    ViewRay<Number> ray_;
    std::deque<Line<Number>> lines_;  ///< regions point at lines: all live as long as the set
    std::array<LinePointer, 4> sides_{};
    std::map<std::array<float, 3>, int> corner_ids_;
    std::map<std::array<int, 2>, int> edge_ids_;  ///< by the ids of their ends, ascending
    struct MeshEdge {
        std::array<glm::vec3, 2> ends_world;
        Slope slope;
        int locus;
    };
    std::vector<MeshEdge> edges_;  ///< by id
    std::vector<std::optional<NeighbourImage>> drawn_;
    std::vector<std::optional<std::vector<Piece>>> pieces_;  ///< in this square
    std::vector<size_t> front_to_back_;
    /// Occluders that cover this square, all edges staying: of what is seen there, once they were found.
    struct Covering {
        std::optional<size_t> seen;
        std::vector<size_t> occluders;
    };
    std::optional<Covering> covering_;
};

}  // namespace zproof
