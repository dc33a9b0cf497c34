/// The first look at a strip: where ids turn and differ, and which depths are certain, by the widest vectors
/// that the machine has.
///
/// kernel_scalar.cpp, kernel_avx2.cpp and kernel_avx512.cpp are compiled for one instruction set each and
/// share the algorithm of certain.inl and ids.inl. All say the same: every lane's operations are those of
/// certain_depths(), in the same order. Plain structs only: an inline function in here would be merged by
/// the linker into whichever instruction set's copy it meets first.
#pragma once

#include <cstdint>

#include "compare/depth_tolerance.h"

namespace zproof::strips {

inline constexpr int width = Strip::width;

/// Bit i is pixel i.
using Pixels = Strip::Pixels;

struct Ids {
    Pixels turns = 0;   ///< the candidate shows another triangle than at the pixel before; the first
    Pixels differ = 0;  ///< the reference shows another triangle than the candidate
};

/// What both frames show along a strip.
struct Depths {
    int x = 0, y = 0;                                        ///< of the first pixel
    const PrimitiveId* primitive = nullptr;                  ///< the candidate's
    const float *candidate = nullptr, *reference = nullptr;  ///< camera depths
    Pixels turns = 1;                                        ///< as Ids has it
    const std::uint32_t* law_of_run = nullptr;  ///< of each run, in order: a place among tolerances
};

/// By what they are certain.
struct Tolerated {
    const DepthTolerance* tolerances = nullptr;  ///< of the tile's triangles
    Projection projection = Projection::perspective;
    double candidate_at_most = 0, reference_at_most = 0;  ///< errors over their bounds
};

struct Kernel {
    const char* name = "";
    /// Of `width` ids each.
    Ids (*compare)(const PrimitiveId* candidate, const PrimitiveId* reference) noexcept = nullptr;
    /// Where the depths of both frames are certain, if both show what the candidate does. Where that is
    /// nothing, they are the background's.
    Pixels (*certain)(const Depths& depths, const Tolerated& by) noexcept = nullptr;
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
