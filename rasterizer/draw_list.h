/// Runs of a scene's triangles that are drawn, left out or put in order as one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "rasterizer/optimizations.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// Indices [begin, end).
struct IndexRange {
    std::uint32_t begin = 0, end = 0;
    bool operator==(const IndexRange&) const = default;
};

/// A run of a part's triangles, the vertices that it uses, and the box around them.
struct Chunk {
    IndexRange triangles, vertices;
    glm::vec3 low{0}, high{0};
    bool is_finite = true;  ///< false: the box means nothing
};

/// The scene in runs of at most 1024 triangles of one part, in order: made once for a scene.
std::vector<Chunk> chunks_of(const Scene& scene);

/// What a view draws, and in which order.
struct DrawList {
    std::vector<IndexRange> triangles;  ///< none twice
    std::vector<IndexRange> vertices;   ///< that those need; rising, none twice
    std::size_t culled = 0;             ///< chunks left out
};

/// Do the optimizations work by chunks?
bool need_chunks(const Optimizations& optimizations);

/// A chunk is left out only where its box lies outside one of the planes by more than rounding could matter
/// (docs/cost.md), so that no pixel's centre is missed.
DrawList draw_list(const std::vector<Chunk>& chunks, const View& view, const Optimizations& optimizations);

}  // namespace zproof::rasterizer
