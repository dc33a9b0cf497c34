/// The first look at a strip: where ids turn and differ, and which depths are certain, by the widest vectors
/// that the machine has; and on which side of an edge a tile's pixels are.
///
/// kernel_scalar.cpp, kernel_avx2.cpp and kernel_avx512.cpp are compiled for one instruction set each and
/// share the algorithms of kernel.inl. All say the same: every lane's operations are those of
/// certain_depths(), in the same order. Plain structs only: an inline function in here would be merged by
/// the linker into whichever instruction set's copy it meets first.
#pragma once

#include <cstdint>

#include "compare/strips/certain_depths.h"
#include "compare/strips/strip.h"
#include "compare/tiles.h"

namespace zproof::strips {

inline constexpr int width = Strip::width;

/// Bit i is pixel i.
using Pixels = Strip::Pixels;

struct Ids {
    Pixels turns = 0;   ///< the candidate shows another triangle than at the pixel before; the first
    Pixels differ = 0;  ///< the reference shows another triangle than the candidate
    int runs = 0;       ///< of the candidate: so often it turns
};

/// What both frames show along a strip.
struct Depths {
    int x = 0, y = 0;                                        ///< of the first pixel
    const PrimitiveId* primitive = nullptr;                  ///< the candidate's
    const float *candidate = nullptr, *reference = nullptr;  ///< camera depths
    Pixels turns = 1;                                        ///< as Ids has it
    Pixels asked = 0;                                        ///< about these; of others, nothing is said
    const std::uint32_t* law_of_run = nullptr;  ///< of each run, in order: a place among tolerances
};

/// By what they are certain.
struct Tolerated {
    const DepthTolerance* tolerances = nullptr;        ///< of the tile's triangles
    const CornerTolerance* next_to_corners = nullptr;  ///< the same; or nothing is said of what lies there
    Projection projection = Projection::perspective;
    double candidate_at_most = 0, reference_at_most = 0;  ///< errors over their bounds
};

/// What one frame shows along a strip, of the triangles that are asked about.
struct OneFrame {
    int x = 0, y = 0;  ///< of the first pixel
    const float* camera_depth = nullptr;
    const Strip::Shown* shown = nullptr;
    int count = 0;
    DepthTolerance::Bound DepthTolerance::*bound = nullptr;          ///< its renderer's
    CornerTolerance::Bound CornerTolerance::*bound_there = nullptr;  ///< next to corners
};

/// What a perspective's runs are looked at with when nothing is known of their triangles but the corners
/// (docs/truth.md, "Runs by themselves"). Of one view and two renderers.
struct RunLens {
    const float* p_world = nullptr;  ///< x, y, z of each vertex
    double eye[3] = {}, back[3] = {};
    double direction[3] = {}, step_x[3] = {}, step_y[3] = {};  ///< of sight, from pixel (0, 0) on
    double direction_abs[3] = {};                              ///< per world axis, the largest in the image
    double width = 0, height = 0, near_depth = 0, far_depth = 0;
    double kept_px = 0;  ///< the displacement of a plane that ends at its corners' depths

    /// One renderer's: no more than what every triangle's law says.
    struct Side {
        double eps_px = 0;      ///< displacement
        double factor = 0;      ///< of depth, but for what products add
        double products = 0;    ///< the error of products, in shares of their absolute sums
        double of_corners = 0;  ///< the absolute error, in shares of a corner's depth
        double absolute = 0;    ///< and what it is beside that
    };
    Side candidate, reference;
};

/// Of some triangles, side by side: where their corners' coordinates are. What follows the last fills a
/// vector.
struct CornerPlaces {
    static constexpr int most = width, room = most + 8;

    std::uint32_t of[3][room];
};

/// The candidate's runs along a strip, side by side; what follows the last fills a vector.
struct Runs {
    std::int32_t first[CornerPlaces::room];  ///< pixel of the strip; behind the last run, the strip's end
    CornerPlaces corners;                    ///< of the triangle; some triangle's, where none is shown
    int count = 0;
    Pixels shown = 0;  ///< bit k: run k shows a triangle
    Pixels bare = 0;   ///< pixels that show none
};

/// The affine function a x + b y + c at the pixels of a tile; values in double precision may be off by
/// `unsure`.
struct Signed {
    double a = 0, b = 0, c = 0, unsure = 0;
    int left = 0, top = 0;  ///< of the tile's pixels
};
/// By row: bit i is column i.
struct Signs {
    static constexpr int side = Tiles::side_px;
    std::uint16_t above[side], below[side];  ///< 0, for certain
};

/// Of some values, which lie above a limit, and which below minus that: bit i is value i.
struct Beyond {
    unsigned above, below;
};

/// An edge of each of eight triangles: a x + b y + c in the middle of a square; anywhere in it values may be
/// off from that by `reach`.
struct EdgesOfEight {
    double a[8], b[8], c[8], reach[8];
};
struct Eight {
    EdgesOfEight edges[3];
};
/// Of eight triangles, bit k is triangle k: covers the square for certain; neither that nor misses it.
struct PlacesOfEight {
    std::uint8_t covers, cuts;
};

/// What a frame shows in a tile: the ids of a row follow each other.
struct IdsOfTile {
    const PrimitiveId* first = nullptr;  ///< of the first row
    std::ptrdiff_t stride = 0;           ///< from row to row
};
/// By row: bit i is column i.
struct ColumnsOfTile {
    std::uint16_t of_row[Tiles::side_px];
};

struct Kernel {
    const char* name = "";
    /// Of `width` ids each.
    Ids (*compare)(const PrimitiveId* candidate, const PrimitiveId* reference) noexcept = nullptr;
    /// Where the depths of both frames are certain, if both show what the candidate does. Where that is
    /// nothing, they are the background's.
    Pixels (*certain)(const Depths& depths, const Tolerated& by) noexcept = nullptr;
    /// Where one frame's depths are lawful for certain.
    Pixels (*lawful)(const OneFrame& frame, const Tolerated& by) noexcept = nullptr;
    /// Of `width` ids, those that are `id`.
    Pixels (*where_shown)(const PrimitiveId* ids, PrimitiveId id) noexcept = nullptr;
    /// The same of some pixels of a tile: `columns` holds them before, and those of them that are `id` after.
    /// Of a row without any, nothing is read.
    void (*where_shown_in_tile)(const IdsOfTile& ids, PrimitiveId id,
                                ColumnsOfTile& columns) noexcept = nullptr;
    /// The same as certain() without tolerances, from the triangles' corners; it may say less.
    Pixels (*certain_by_corners)(const Depths& depths, const Runs& runs, const RunLens& lens,
                                 const AtMost& at_most) noexcept = nullptr;
    /// Of `count` triangles in a tile, as tolerance_of has it; they may say less.
    void (*set_tolerances)(const RunLens& lens, const CornerPlaces& corners, int count, const PixelBox& tile,
                           DepthTolerance* tolerances) noexcept = nullptr;
    void (*set_signs)(const Signed& of, Signs& signs) noexcept = nullptr;
    /// Of `count` times eight triangles, in the square around (x, y).
    void (*set_places)(const Eight* triangles, int count, double x, double y,
                       PlacesOfEight* places) noexcept = nullptr;
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

}  // namespace zproof::strips
