/// Which kernels this machine can run.
#pragma once

#include <array>
#include <vector>

#include "math/processor.h"
#include "rasterizer/kernel.h"

namespace zproof::rasterizer {

/// In the order of InstructionSet.
inline constexpr std::array kernels{
    &scalar::kernel,
#ifdef __x86_64__
    &avx2::kernel,
    &avx512::kernel,
#endif
};

inline std::vector<Kernel> available_kernels() { return available_of(kernels); }

/// The one for widest_allowed().
inline const Kernel& widest_kernel() { return widest_of(kernels); }

}  // namespace zproof::rasterizer
