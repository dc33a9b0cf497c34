/// What lies over the pixels of one tile, layer upon layer: decides answers row by row where every triangle
/// near a pixel covers its square or misses it for certain, in double precision (docs/truth.md, "Layers").
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compare/acquaintance.h"
#include "compare/standing.h"
#include "compare/triangle_row.h"

namespace zproof {

class Layers {
  public:
    static constexpr std::size_t most = 64;
    struct Shared {
        const Sights<double>& sights;
        Acquaintance& acquaintance;
        CoplanarMemory& coplanar;
    };

    /// `centres` holds those of all pixels that will be asked about, none of them farther right than its
    /// first column by tile_columns; `near` every triangle within the reach of any of them.
    Layers(const Shared& shared, const Around& centres, std::span<const std::uint32_t> near,
           std::span<const ViewBounds* const> renderers);

    /// Are there few enough triangles, all of them trusted? If not, nothing may be asked.
    bool are_known() const { return are_known_; }
    /// No square in the tile has a larger half-side.
    double widest_px() const { return widest_px_; }

    /// Turns to another row. Nothing may be asked of it where it gives none of these pixels back: those whose
    /// squares no edge may cut.
    ColumnMask turn_to(int y, ColumnMask pixels);

    /// Pixels of the row at which an answer is certainly what Standing calls tied or visible, the latter at
    /// the centre.
    struct Standings {
        ColumnMask tied = 0, visible = 0;
    };
    /// Of the pixels at which the renderer shows that triangle.
    Standings standings(std::size_t renderer, std::uint32_t triangle, ColumnMask pixels);
    /// The half-side of the square, where an answer's standing is certain.
    TileRow eps_px(std::size_t renderer);

  private:
    using Set = std::uint64_t;  ///< bit k is layers_[k]
    /// What others are to one triangle, wherever in the tile they are.
    struct Relations {
        Set level = 0;   ///< in its plane
        Set behind = 0;  ///< farther
        Set ahead = 0;   ///< nearer
        Set crossing() const {
            return ~(level | behind | ahead);
        }  ///< now nearer, now farther, or too close to tell
    };
    struct Layer {
        std::uint32_t triangle;
        const KnownTriangle* known;
        std::uint32_t cutting = 0;  ///< bit k: edge k may pass somewhere in the tile
        std::optional<Relations> others{};
        ColumnMask covers = 0;             ///< of the row
        std::optional<TriangleRow> row{};  ///< as far as it was asked for
    };
    struct Renderer {
        const ViewBounds* bounds;
        std::vector<const BoundedTriangle*> triangles;  ///< of layers_, in order
        Set clear = 0;                                  ///< of near and far, all over the tile
        ColumnMask unclear = 0;                         ///< of the row: covered by one that is not clear
        std::vector<TriangleRow::Range> nearness;       ///< of the row
        Set known = 0;                                  ///< whose nearness was asked for
        std::vector<std::optional<Set>> close;          ///< to each layer, as is_close() has it
    };

    void place(int y);
    void meet(std::span<const std::uint32_t> near);
    void sort_out();
    const TriangleRow& row_of(std::size_t layer);
    const Relations& relations_of(std::size_t layer);
    std::optional<std::size_t> index_of(std::uint32_t triangle) const;
    bool is_close(const Renderer& renderer, std::size_t front, std::size_t back) const;
    Set close_to(Renderer& renderer, std::size_t back);
    const TriangleRow::Range& nearness(Renderer& renderer, std::size_t layer);
    ColumnMask ahead_for_certain(Renderer& renderer, std::size_t front, std::size_t back);

    Shared shared_;
    Around tile_;
    int left_;
    double widest_px_ = 0;  ///< no square in the tile has a larger half-side
    bool are_known_ = true;
    std::vector<Layer> layers_;
    std::vector<Renderer> renderers_;
    RowPlace row_;
    ColumnMask cut_ = 0;             ///< of the row: pixels whose square some edge may cut
    ColumnMask asked_ = 0;           ///< of the row
    std::optional<SightRow> sight_;  ///< of the row, once it was asked for
};

}  // namespace zproof
