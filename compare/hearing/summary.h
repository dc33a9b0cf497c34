/// Most answers can be decided without polygons: by one place at which the answer is certainly seen, or by
/// what certainly covers the whole square (docs/truth.md, "Decided summarily").
#pragma once

#include "compare/hearing/ruled.h"
#include "compare/hearing/square_places.h"
#include "compare/search/acquaintance.h"
#include "compare/truth/estimate.h"

namespace zproof {

/// An answer to be decided at the pixel in hand.
struct Plaint {
    const ViewBounds* bounds = nullptr;
    PrimitiveId answer = PrimitiveId::none;
    double own_eps_px = 0;
    double reach_px = 0;  ///< every triangle that comes so near the pixel's centre is known
    Asked asked = Asked::standing;
};

/// Decides answers at the pixels of one tile after the other, one pixel after the other, in double precision.
class Summary {
  public:
    struct Shared {
        const View& view;
        const Sights<double>& sights;
        Acquaintance& acquaintance;
        CoplanarMemory& coplanar;
    };

    explicit Summary(const Shared& shared) : shared_(shared) {}

    /// Turns to another tile: `tile` holds the centres of all pixels that will be asked about, `near` every
    /// triangle within the reach of any of them, `renderers` the bounds of all plaints. What is known of
    /// triangles must not be forgotten until it turns to the next.
    void turn_to(const Around& tile, std::span<const std::uint32_t> near,
                 std::span<const ViewBounds* const> renderers);
    /// Turns to another pixel of it.
    void look_at(int x, int y) { x_ = x, y_ = y, is_sorted_out_ = false, ++pixel_; }
    /// What decide() and displacement_over_eps() would say in the neighbourhood of the pixel. Nothing where
    /// that takes more than this. The estimate, of the same answer there, is asked for places to look at, and
    /// of squares that leave the displacement open.
    std::optional<Ruled> rule(const Plaint& plaint, Estimate& estimate);
    /// The reach that a plaint needs, where its own is known to be too short; else 0.
    double lacking_reach_px(const Plaint& plaint);

  private:
    using Place = TriangleFilter::Place;
    /// A triangle that does not certainly miss the tile.
    struct Present {
        std::uint32_t triangle;
        const KnownTriangle* known;
        bool covers_tile;
    };
    /// What a renderer may hold for a triangle's nearness at the pixel in hand.
    struct Nearness {
        std::uint32_t pixel = 0;  ///< as pixel_ counts them: of an earlier one it says nothing
        NearnessRange range{};
    };
    /// A triangle that is present, by a renderer's bounds.
    struct Bounded {
        Bounded(const BoundedTriangle& of, double most) : triangle(&of), most_eps_px(most) {}

        const BoundedTriangle* triangle;
        double most_eps_px;  ///< anywhere in the tile
        mutable Nearness nearness{};
    };
    struct Renderer {
        const ViewBounds* bounds = nullptr;
        std::vector<Bounded> triangles;                 ///< of present_, in order
        bool is_never_cut = true;                       ///< any of them
        std::vector<std::optional<Standing>> standing;  ///< by present_, of all pixels; if all cover the tile

        void turn_to(const ViewBounds& to);
    };
    /// A square around the pixel's centre, or a place in it.
    Around square(double half_side_px) const { return {double(x_), double(y_), half_side_px, half_side_px}; }

    void meet(std::span<const std::uint32_t> near);
    void sort_out();
    void sort_out_pixel();
    const TriangleFilter& filter(std::size_t i) const { return present_[i].known->filter; }
    Renderer& renderer_of(const ViewBounds* bounds);
    double eps_px(const Renderer& renderer, const Plaint& plaint, std::optional<std::size_t> answer) const;
    bool is_uncut(const Renderer& renderer) const;
    bool covers(const Renderer& renderer, std::size_t i, const Around& box) const;
    std::optional<std::size_t> index_of(PrimitiveId answer) const;

    bool is_inside(std::size_t i, const PixelOffset& at) const;
    bool is_outside(std::size_t i, const PixelOffset& at) const;
    bool is_behind(std::size_t back, std::size_t front, const PixelOffset& at) const;
    void find_rivals(std::optional<std::size_t> answer);
    bool is_seen_at(std::optional<std::size_t> answer, const PixelOffset& at) const;
    template <class IsThere>
    bool is_anywhere(std::optional<std::size_t> answer, double half_side_px, const IsThere& is_there) const;
    bool is_seen_around(std::optional<std::size_t> answer, double half_side_px) const;
    bool is_seen_in_part(std::size_t answer, double half_side_px) const;
    bool is_seen_where(std::size_t answer, double half_side_px, Estimate& estimate) const;
    bool is_held_around(const Renderer& renderer, std::size_t answer, double half_side_px) const;
    /// What a triangle has of a square: a polygon, convex.
    struct Part {
        std::array<PixelOffset, 8> corner;
        std::size_t count = 0;

        bool is_empty() const { return count < 3; }
        const PixelOffset& next_corner(std::size_t k) const { return corner[k + 1 < count ? k + 1 : 0]; }
        PixelOffset middle() const;
    };
    Part part_of(std::size_t i, double half_side_px) const;
    bool are_coplanar(std::size_t a, std::size_t b) const;
    bool is_hidden_in(const Renderer& renderer, std::optional<std::size_t> answer, double half_side_px) const;
    bool covers_all_of(const Renderer& renderer, std::size_t i, std::size_t other, const Around& box) const;
    bool shares_edge(std::size_t i, std::size_t edge, std::size_t other) const;
    bool hides(const Renderer& renderer, std::size_t front, std::size_t back, const Around& box) const;
    const NearnessRange& nearness_of(const Renderer& renderer, std::size_t i) const;
    bool may_be_hidden_for_certain(const Renderer& renderer, std::size_t front, std::size_t back) const;
    template <class IsCertain>
    bool is_tied(const Renderer& renderer, std::size_t answer, std::span<const std::size_t> others,
                 const Around& box, const IsCertain& may_be_certain) const;
    std::optional<Standing> standing_in_tile(Renderer& renderer, std::size_t answer);
    double likely_displacement_px(std::optional<std::size_t> answer) const;
    Ruled visible(const Renderer& renderer, const Plaint& plaint, std::optional<std::size_t> answer,
                  double eps_px, Estimate& estimate) const;

    Shared shared_;
    std::vector<Present> present_;
    std::vector<Renderer> renderers_;
    Around tile_{};
    double widest_px_ = 0;  ///< no square in the tile has a larger half-side
    bool all_cover_ = true;
    int x_ = 0, y_ = 0;
    std::uint32_t pixel_ = 0;     ///< how many pixels it turned to
    bool is_sorted_out_ = false;  ///< do sight_, covering_ and cutting_ speak of the pixel?
    Sight<double> sight_;
    std::vector<std::size_t> covering_, cutting_;  ///< the pixel's widest square
    std::vector<std::size_t> rivals_;              ///< of these: may hide the answer in hand there
    std::vector<std::size_t> untrusted_;           ///< of present_
    SquarePlaces places_;                          ///< of present_, in the widest squares
};

}  // namespace zproof
