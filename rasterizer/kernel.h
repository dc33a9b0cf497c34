/// The kernels: vertices, bin entries, and triangles into one tile's z-buffer, by the widest vectors
/// that the machine has.
///
/// kernel_scalar.cpp, kernel_avx2.cpp and kernel_avx512.cpp are compiled for one instruction set each and
/// share the algorithms of kernel.inl. All give the same bits: whole numbers stay whole numbers below 2^53,
/// and every pixel's depth takes the same operations in the same order. What they use of headers is plain
/// data and functions marked always_inline: the linker would merge any other inline function into whichever
/// instruction set's copy it meets first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "frame/frame.h"
#include "rasterizer/depth_functional.h"
#include "rasterizer/optimizations.h"
#include "rasterizer/tile_pixels.h"
#include "rasterizer/triangles.h"

namespace zproof::rasterizer {

struct ViewSetup;

/// What a tile was made of. Whole numbers, the same for every instruction set and number of threads.
struct Tally {
    std::uint64_t blocks = 0;         ///< of 4 x 4 pixels that a triangle may cover
    std::uint64_t hidden_blocks = 0;  ///< of those, left alone because all they hold is nearer
    std::uint64_t fragments = 0;      ///< covered pixels of the image in the others: depth tests
    std::uint64_t written = 0;        ///< tests that were passed
};

/// When a fragment is shaded.
enum class ShadingTime {
    before_the_test,  ///< late z: every covered pixel of every triangle
    after_the_test,   ///< early z: those that pass
};

/// What becomes of a shaded fragment.
enum class DepthTestResult { kept, discarded };

/// Called for the fragments of pixel (x, y) of the image, in the order of drawing.
struct FragmentShader {
    void (*shade)(void* context, PrimitiveId id, int x, int y, DepthTestResult result) = nullptr;
    void* context = nullptr;
    ShadingTime time = ShadingTime::after_the_test;
};

/// Which of several equally near triangles owns the pixel. Both are the same where triangles come in the
/// order of their ids.
enum class Ties { first_to_come, least_id };

/// The number of triangles that are set up together.
inline constexpr int batch_size = 16;

/// Some triangles for one tile, in the order of drawing. They need an area and to be within the guard band.
struct TileWork {
    const Triangles& triangles;
    const std::uint32_t* entries = nullptr;
    std::uint32_t count = 0;
    const TileSamples& samples;
    TilePixels& pixels;
    HierarchicalZ hierarchical_z = HierarchicalZ::blocks;
    Ties ties = Ties::first_to_come;         ///< for draw and draw_tallied; others have that
    const float* nearest_left = nullptr;     ///< for draw: TilePlaces has it (tile.h)
    Tally* tally = nullptr;                  ///< for draw_tallied
    const FragmentShader* shader = nullptr;  ///< for draw_shaded
};

/// Vertices to be projected.
struct VertexWork {
    const ViewSetup& setup;
    const glm::vec3* position_world = nullptr;
    SnappedVertex* snapped = nullptr;
    std::uint8_t* outcode = nullptr;
    std::size_t count = 0;
};

/// Triangles side by side, to be placed together. [k] is a corner.
struct CornerLanes {
    static constexpr int count = 16;
    alignas(64) SnappedPoint corner[3][count];
};

/// The tiles that triangles may cover samples of: from column0, row0 to column1, row1; none where column1 is
/// the lesser.
struct PlacedLanes {
    alignas(64) std::int32_t column0[CornerLanes::count], column1[CornerLanes::count];
    alignas(64) std::int32_t row0[CornerLanes::count], row1[CornerLanes::count];
    alignas(64) std::uint32_t turn[CornerLanes::count];       ///< `turned`, or 0
    alignas(64) std::int32_t faces_away[CornerLanes::count];  ///< 1 where that alone is why there are none
    bool in_one_tile;                                         ///< all, in the same
    std::uint64_t cover_px;                                   ///< all together, as BinTally has it
};

/// A tile's pixels, to be written into a frame.
struct ResolveWork {
    const TilePixels& pixels;
    DepthFunctional depth;
    float* camera_depth = nullptr;  ///< of the tile's first pixel
    PrimitiveId* primitive = nullptr;
    std::size_t stride = 0;  ///< pixels, from row to row of the frame
    int columns = tile_size, rows = tile_size;
};

enum class Isa { scalar, avx2, avx512 };

struct Kernel {
    Isa isa = Isa::scalar;
    const char* name = "";
    void (*project)(const VertexWork&) noexcept = nullptr;
    PlacedLanes (*place)(const ViewSetup&, const CornerLanes&) noexcept = nullptr;
    /// Clears the tile: nothing is seen yet, and `primitive` is the same everywhere.
    void (*clear)(TilePixels&, std::uint32_t primitive) noexcept = nullptr;
    void (*resolve)(const ResolveWork&) noexcept = nullptr;
    void (*publish)() noexcept = nullptr;              ///< what this thread resolved, before another may look
    void (*draw)(const TileWork&) noexcept = nullptr;  ///< depth test, depth and id of every covered pixel
    void (*count)(const TileWork&) noexcept = nullptr;  ///< one more in `primitive` of every covered pixel
    // These draw the pixels of `draw`, as `hierarchical_z` says, and do more beside. Only the first has to be
    // fast.
    void (*draw_every_block)(const TileWork&) noexcept = nullptr;  ///< without hierarchical z
    void (*draw_tallied)(const TileWork&) noexcept = nullptr;      ///< counts into `tally`
    void (*draw_shaded)(const TileWork&) = nullptr;                ///< hands fragments to `shader`
};

namespace scalar {
extern const Kernel kernel;
}
namespace avx2 {
extern const Kernel kernel;
}
namespace avx512 {
extern const Kernel kernel;
}

/// One for each InstructionSet of the machine, for widest_of() and available_of().
inline constexpr const Kernel* kernels[] = {
    &scalar::kernel,
#ifdef __x86_64__
    &avx2::kernel,
    &avx512::kernel,
#endif
};

}  // namespace zproof::rasterizer
