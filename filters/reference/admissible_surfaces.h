/// Which surface a pixel shows, by exact geometry: for pictures of textures and for checks of them.
#pragma once

#include <span>
#include <vector>

#include "filters/conformance/filter_precision.h"
#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// The surfaces that a renderer may show at each pixel of a view, given its promise: arithmetic_bits and
/// displacement_px. A triangle is left out only where it certainly does not cover the sample, or where nearer
/// ones certainly cover it all; background, where triangles certainly cover the sample. Triangles that share
/// an edge move it alike. Back faces count. A surface farther than displacement_px + 1 px is never
/// admissible.
class AdmissibleSurfaces {
  public:
    /// On the threads of the surrounding tbb::task_arena.
    AdmissibleSurfaces(const Scene& scene, const View& view, const FilterPrecision& precision);

    /// Ascending, background last. Never empty.
    std::span<const PrimitiveId> at(int x, int y) const {
        const Row& row = rows_[std::size_t(y)];
        const std::size_t first = row.first[std::size_t(x)], end = row.first[std::size_t(x) + 1];
        return std::span{row.ids}.subspan(first, end - first);
    }

  private:
    struct Row {
        std::vector<std::size_t> first{0};  ///< of each pixel's ids, and where the last one's end
        std::vector<PrimitiveId> ids;
    };
    std::vector<Row> rows_;
};

/// The nearest triangle at every pixel's centre, decided in rationals where doubles cannot tell; edges belong
/// to their triangles, and of equally near triangles the first is seen. Depth is camera depth. On the threads
/// of the surrounding tbb::task_arena.
Frame exact_visibility(const Scene& scene, const View& view);

}  // namespace zproof::oracle
