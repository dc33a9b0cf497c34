/// What lies over the pixels of a tile, layer upon layer: decides answers side by side where every triangle
/// near a pixel covers its square or misses it for certain, in double precision (docs/truth.md, "Layers").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compare/layers/by_row.h"
#include "compare/layers/triangle_row.h"
#include "compare/search/acquaintance.h"
#include "compare/tile_mask.h"
#include "compare/truth/standing.h"

namespace zproof {

class Layers {
  public:
    static constexpr std::size_t most = 64;
    struct Shared {
        const Sights<double>& sights;
        Acquaintance& acquaintance;
        CoplanarMemory& coplanar;
    };

    explicit Layers(const Shared& shared) : shared_(shared) {}

    /// Turns to another tile: `centres` holds those of all pixels that will be asked about; `near` every
    /// triangle within the reach of any of them. What is known of triangles must not be forgotten until it
    /// turns to the next.
    void turn_to(const TilePlace& tile, const Around& centres, std::span<const std::uint32_t> near,
                 std::span<const ViewBounds* const> renderers);

    /// Are there few enough triangles, all of them trusted? If not, nothing may be asked.
    bool are_known() const { return are_known_; }
    /// No square in the tile has a larger half-side.
    double widest_px() const { return widest_px_; }

    /// Of those pixels, the ones whose squares no edge may cut. Nothing may be asked of others, nor before.
    TileMask uncut(const TileMask& pixels);

    /// Pixels at which an answer is certainly what Standing calls tied or visible, the latter at
    /// the centre.
    struct Standings {
        TileMask tied, visible;
    };
    /// Of the pixels at which the renderer shows that triangle.
    Standings standings(std::size_t renderer, std::uint32_t triangle, const TileMask& pixels);
    /// The half-side of the square, where an answer's standing is certain, along a row.
    TileRow eps_px(std::size_t renderer, int y);

  private:
    /// What another triangle is to an answer, all over the tile.
    enum class Relation : std::uint8_t {
        not_asked,
        level,     ///< in its plane
        behind,    ///< farther
        ahead,     ///< nearer
        crossing,  ///< now nearer, now farther, or too close to tell
    };
    struct Layer {
        std::uint32_t triangle;
        const KnownTriangle* known;
        std::uint32_t cutting = 0;  ///< bit k: edge k may pass somewhere in the tile
        TileMask covers{};
        ByRow<TriangleRow> rows{};
    };
    struct Renderer {
        const ViewBounds* bounds = nullptr;
        std::vector<const BoundedTriangle*> triangles;      ///< of layers_, in order
        TileMask unclear{};                                 ///< covered by one that near or far may cut
        std::vector<ByRow<TriangleRow::Range>> nearness{};  ///< of layers_

        void turn_to(const ViewBounds& to);
    };

    void meet(std::span<const std::uint32_t> near);
    void sort_out();
    const TriangleRow& row_of(std::size_t layer, int y);
    Relation relation(std::size_t other, std::size_t answer);
    bool are_coplanar(std::size_t one, std::size_t other);
    std::optional<std::size_t> index_of(std::uint32_t triangle) const;
    bool is_close(const Renderer& renderer, std::size_t front, std::size_t back) const;
    const TriangleRow::Range& nearness(Renderer& renderer, std::size_t layer, int y);
    TileMask ahead_for_certain(Renderer& renderer, std::size_t front, std::size_t back,
                               const TileMask& pixels);

    Shared shared_;
    TilePlace place_;
    Around tile_{};
    double widest_px_ = 0;  ///< no square in the tile has a larger half-side
    bool are_known_ = true;
    std::vector<Layer> layers_;
    std::vector<Renderer> renderers_;
    std::vector<Relation> relations_;  ///< by answer, of each layer
    ByRow<SightRow> sights_;
};

}  // namespace zproof
