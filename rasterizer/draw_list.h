/// Runs of a scene's triangles that are drawn, left out or put in order as one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "rasterizer/tricks.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// Indices [begin, end).
struct Range {
    std::uint32_t begin = 0, end = 0;
    bool operator==(const Range&) const = default;
};

/// A run of a part's triangles, the vertices that it uses, and the box around them.
struct Chunk {
    Range triangles, vertices;
    glm::vec3 low{0}, high{0};
    bool is_finite = true;  ///< false: the box means nothing
};

/// The scene in runs of at most 1024 triangles of one part, in order: made once for a scene.
std::vector<Chunk> chunks_of(const Scene& scene);

/// What a view draws, and in which order.
struct DrawList {
    std::vector<Range> triangles;  ///< none twice
    std::vector<Range> vertices;   ///< that those need; rising, none twice
    std::size_t culled = 0;        ///< chunks left out
};

/// Do the tricks work by chunks?
bool need_chunks(const Tricks& tricks);

/// A chunk is left out only where its box lies outside one of the planes by more than rounding could matter
/// (docs/cost.md), so that no pixel's centre is missed.
DrawList draw_list(const std::vector<Chunk>& chunks, const View& view, const Tricks& tricks);

}  // namespace zproof::rasterizer
