#include "compare/strips/dispatch.h"

#include "math/processor.h"

namespace zproof::strips {

std::vector<Kernel> available_kernels() {
#ifdef __x86_64__
    return runnable(scalar::kernel, avx2::kernel, avx512::kernel);
#else
    return {scalar::kernel};
#endif
}

const Kernel& widest_kernel() {
    static const Kernel widest = available_kernels().back();
    return widest;
}

}  // namespace zproof::strips
