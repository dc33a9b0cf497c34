/// What the processor can do, for code that is compiled once per instruction set.
#pragma once

#include <vector>

namespace zproof {

/// May code run here that was compiled with -mavx2, or with -mavx512f, dq, vl and bw? By what the processor
/// says of itself; no on everything but x86.
bool has_avx2();
bool has_avx512();

/// The kernels of three that may run here, narrowest first; the scalar one may everywhere.
template <typename Kernel>
std::vector<Kernel> runnable(const Kernel& scalar, const Kernel& avx2, const Kernel& avx512) {
    std::vector<Kernel> kernels{scalar};
    if (has_avx2()) kernels.push_back(avx2);
    if (has_avx512()) kernels.push_back(avx512);
    return kernels;
}

}  // namespace zproof
