#include "texture/reads/dispatch.h"

namespace zproof::texture::reads {

std::vector<Kernel> available_kernels() {
    std::vector<Kernel> kernels{scalar::kernel};
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2")) kernels.push_back(avx2::kernel);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
        kernels.push_back(avx512::kernel);
#endif
    return kernels;
}

const Kernel& widest_kernel() {
    static const Kernel widest = available_kernels().back();
    return widest;
}

}  // namespace zproof::texture::reads
