/// The first look at a strip: pixels whose ids and depths plainly agree are settled by tolerances.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "compare/certain_depths.h"

namespace zproof {

/// One thread at a time.
class Presort {
  public:
    explicit Presort(Projection projection) : projection_(projection) {}

    /// Turns to another tile, and forgets the laws of the last.
    void turn_to(const PixelBox& tile) {
        tile_ = tile;
        ++tile_number_;
    }
    /// The largest ratio of each renderer.
    struct Largest {
        double candidate = 0, reference = 0;
    };

    /// Fills in what is open of whole chunks of the strip, and marks them as sorted; raises the largest. The
    /// laws are those of the tile.
    void sort(const LawsOfBoth& laws, Largest& largest, const Strip& strip, SortedStrip& sorted);

  private:
    /// The depth of a triangle that lies at one depth all over the image, and its ratio; no number at first.
    struct Level {
        float depth = std::numeric_limits<float>::quiet_NaN();
        double ratio = 0;
    };
    struct Known {
        std::uint64_t tile = 0;
        DepthTolerance tolerance{};
        Level candidate, reference;
    };
    /// What a chunk is sorted by.
    struct Source {
        const LawsOfBoth& laws;
        Largest& largest;
        const Strip& strip;
        std::size_t first;                   ///< of the chunk's pixels in the strip
        const std::uint32_t *ours, *theirs;  ///< the laws of its pixels

        RowPlace place() const { return {strip.x + int(first), strip.y}; }
        AtMost at_most() const { return {largest.candidate, largest.reference}; }
    };
    /// One renderer's part in it.
    struct Part {
        const DepthLaw& law;
        const float* camera_depth;
        Level& level;
        double& largest;

        void raise(double ratio) const { largest = std::max(largest, ratio); }
        void raise(const TileRow& ratio, ColumnMask pixels) const;
    };
    struct PartsOfBoth {
        Part candidate, reference;
    };
    Known& known_by(std::uint32_t law, const LawsOfBoth& laws);
    static PartsOfBoth parts_of(const Source& source, std::uint32_t law, Known& known);
    static ColumnsOfBoth level_ones(const PartsOfBoth& parts);
    ColumnsOfBoth lawful_by(std::uint32_t law, const ColumnsOfBoth& here, const Source& source);
    /// Which of those depths are lawful, and of those that are counted, which do not exceed the largest?
    struct Question {
        ColumnsOfBoth pixels;
        ColumnMask counted;
    };
    ColumnsOfBoth uncertain_by(const DepthTolerance& tolerance, const Question& asked,
                               const Source& source) const;
    ColumnsOfBoth uncertain_here(std::uint32_t law, Question asked, const Source& source) const;
    ColumnsOfBoth lawful_in_full(const ColumnsOfBoth& here, const ColumnsOfBoth& asked,
                                 const PartsOfBoth& parts, const RowPlace& place) const;
    ColumnMask unlawful_in_full(const Part& part, ColumnMask asked, const RowPlace& place,
                                TileRow& ratio) const;
    bool is_of_one_triangle(const LawsOfBoth& laws, const Largest& largest, const Strip& strip);
    bool sort_one_law(const Source& source, SortedStrip& sorted);
    bool sort_some_laws(const Source& source, SortedStrip& sorted);

    Projection projection_;
    PixelBox tile_{};
    std::uint64_t tile_number_ = 0;
    std::vector<Known> known_;  ///< by law; of this tile where its number is the present one
};

}  // namespace zproof
