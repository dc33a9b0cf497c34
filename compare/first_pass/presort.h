/// The first look at a strip: pixels whose ids and depths plainly agree are settled by tolerances.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "compare/first_pass/held_depths.h"
#include "compare/first_pass/run_lens.h"
#include "compare/first_pass/shown_triangles.h"
#include "compare/strips/certain_depths.h"
#include "compare/strips/kernel.h"

namespace zproof {

/// One thread at a time.
class Presort {
  public:
    /// All must outlive it.
    Presort(const Scene& scene, const Witness& candidate, const Witness& reference,
            const strips::Kernel& kernel);

    /// Turns to another tile, which shows these.
    void turn_to(const PixelBox& tile, const ShownTriangles& shown);
    /// Turns to another tile, of which nothing is known yet.
    void turn_to_unknown();
    /// The largest ratio of each renderer.
    struct Largest {
        double candidate = 0, reference = 0;
    };

    /// Fills in what is open of whole chunks of the tile's strip, and marks them as sorted; raises the
    /// largest. Few strips ask for laws.
    void sort(ShownTriangles& shown, Largest& largest, const Strip& strip, SortedStrip& sorted);

    /// Do triangles' corners say enough?
    bool knows_corners() const { return lens_.has_value(); }
    /// If so: where depths are certain by what they say, and both frames show the same.
    Strip::Pixels certain_by_corners(const Largest& largest, const Strip& strip,
                                     const strips::Runs& runs) const;
    /// As sort(), where only that is known of the tile; laws of all that is shown in chunks with other pixels
    /// are along the strip.
    void sort_others(ShownTriangles& shown, Largest& largest, const Strip& strip, Strip::Pixels certain,
                     SortedStrip& sorted);

  private:
    /// Depths whose ratios the largest have met already; none at first.
    struct Met {
        float candidate = std::numeric_limits<float>::quiet_NaN(), reference = candidate;
    };
    /// What a chunk is sorted by.
    struct Source {
        ShownTriangles& shown;
        Largest& largest;
        const Strip& strip;
        std::size_t first;                   ///< of the chunk's pixels in the strip
        const std::uint32_t *ours, *theirs;  ///< the laws of its pixels
        ColumnMask settled;                  ///< of them

        RowPlace place() const { return {strip.x + int(first), strip.y}; }
        AtMost at_most() const { return {largest.candidate, largest.reference}; }
    };
    /// One renderer's part in it.
    struct Part {
        const DepthLaw& law;
        const float* camera_depth;
        float& met;
        double& largest;

        void raise(const TileRow& ratio, ColumnMask pixels) const;
    };
    struct PartsOfBoth {
        Part candidate, reference;
    };
    Strip::Pixels certain_where_same(const Strip& strip, const Largest& largest) const;
    Strip::Pixels certain_if_same(const Strip& strip, const Largest& largest, Strip::Pixels asked) const;
    Strip::Pixels certain_where_level(const Strip& strip, const Largest& largest, Strip::Pixels asked) const;
    struct PixelsOfBoth {
        Strip::Pixels candidate = 0, reference = 0;
    };
    PixelsOfBoth met_where_level(const Strip& strip, Strip::Pixels asked) const;
    PartsOfBoth parts_of(const Source& source, std::uint32_t law);
    ColumnsOfBoth met_already(std::uint32_t law, const Source& source) const;
    ColumnsOfBoth lawful_by(std::uint32_t law, const ColumnsOfBoth& here, const Source& source);
    /// Which of those depths are lawful, and of those that are counted, which do not exceed the largest?
    struct Question {
        ColumnsOfBoth pixels;
        ColumnMask counted;
    };
    struct ToleratedBy {
        const DepthTolerance* far_off;
        const CornerTolerance* next_to_corners;  ///< or nothing is said of what lies there
    };
    ColumnsOfBoth uncertain_by(const ToleratedBy& by, const Question& asked, const Source& source) const;
    ColumnsOfBoth uncertain_here(std::uint32_t law, const Question& asked, const Source& source) const;
    ColumnsOfBoth lawful_in_full(const ColumnsOfBoth& here, const ColumnsOfBoth& asked,
                                 const PartsOfBoth& parts, const RowPlace& place) const;
    ColumnMask unlawful_in_full(const Part& part, ColumnMask asked, const RowPlace& place,
                                TileRow& ratio) const;
    /// Pixels of which nothing more is asked; where frames differ, those of them with lawful depths.
    struct Decided {
        Strip::Pixels all = 0, lawful = 0;
    };
    Decided decided_where_they_differ(const Strip& strip) const;
    void sort_chunks(ShownTriangles& shown, Largest& largest, const Strip& strip, const Decided& decided,
                     SortedStrip& sorted);
    bool sort_chunk(const Source& source, SortedStrip& sorted);

    const Scene& scene_;
    Projection projection_;
    const strips::Kernel& kernel_;
    std::optional<strips::RunLens> lens_;
    const CornerTolerance* corner_tolerances() const {
        return corner_tolerances_.empty() ? nullptr : corner_tolerances_.data();
    }

    std::vector<DepthTolerance> tolerances_;          ///< by law
    std::vector<CornerTolerance> corner_tolerances_;  ///< by law; none where corners are asked themselves
    std::vector<Met> met_;                            ///< by law
    bool met_level_ = false;                          ///< has any level triangle's depth been met?
};

}  // namespace zproof
