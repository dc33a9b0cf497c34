/// Each visibility optimization alone, and all together: what it saves, and what the gate says of its
/// picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/cost/timing.h"
#include "rasterizer/pipeline.h"

namespace zproof::study::cost {

/// A picture held against that of the plain z-buffer, and judged.
struct Sameness {
    std::uint64_t other_ids = 0;     ///< pixels that name another triangle
    std::uint64_t other_depths = 0;  ///< pixels whose depth has other bits
    std::uint64_t defects = 0;       ///< pixels that fail the gate, Embree as the reference
};

struct OptimizationRun {
    std::string name;
    rasterizer::Optimizations optimizations;
    rasterizer::Work work;
    Timing timing;  ///< of visibility: no pixel is shaded
    Sameness same;
};

/// A run that shades fragments at one time of the pipeline.
struct ShadingRun {
    std::string name;
    std::uint64_t shaded = 0;         ///< fragments
    Timing timing;                    ///< visibility and shading
    std::uint64_t other_colours = 0;  ///< pixels that differ from the deferred picture
};

struct OptimizationStudy {
    std::string scene, view;
    /// Directed edges without one in the other direction, corners compared by place: 0 for closed meshes.
    std::uint64_t open_edges = 0;
    std::vector<OptimizationRun> runs;  ///< the plain z-buffer first
    std::vector<ShadingRun> shading;
};

std::uint64_t open_edge_count(const Scene& scene);

/// `repeats` runs for each time. Frames that have the bits of the plain one share its verdict. Throws
/// OracleError. All but the times is the same for any number of threads.
OptimizationStudy study_optimizations(const Scene& scene, const View& view, int repeats);

}  // namespace zproof::study::cost
