#include "rasterizer/projected_vertices.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace zproof::rasterizer {

void ProjectedVertices::fill(const Vertices& vertices, const ViewSetup& setup) {
    const IndexRange all{0, std::uint32_t(vertices.position_world.size())};
    fill(vertices, setup, std::span(&all, 1));
}

void ProjectedVertices::fill(const Vertices& vertices, const ViewSetup& setup,
                             std::span<const IndexRange> ranges) {
    snapped_.resize(vertices.position_world.size());
    outcode_.resize(vertices.position_world.size());
    for (const IndexRange& r : ranges)
        tbb::parallel_for(tbb::blocked_range<std::size_t>(r.begin, r.end, 1024), [&](const auto& range) {
            const std::size_t first = range.begin();
            kernel_.project({setup, vertices.position_world.data() + first, snapped_.data() + first,
                             outcode_.data() + first, range.size()});
        });
}

}  // namespace zproof::rasterizer
