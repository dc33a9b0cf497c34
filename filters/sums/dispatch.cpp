#include "filters/sums/dispatch.h"

#include <array>

#include "math/processor.h"

namespace zproof::texture::sums {
namespace {

/// In the order of InstructionSet.
constexpr std::array kernels{
    &scalar::kernel,
#ifdef __x86_64__
    &avx2::kernel,
    &avx512::kernel,
#endif
};

const Kernel& kernel_for(InstructionSet set) { return *kernels.at(std::size_t(set)); }

}  // namespace

std::vector<Kernel> available_kernels() {
    std::vector<Kernel> available;
    for (const InstructionSet set : instruction_sets()) available.push_back(kernel_for(set));
    return available;
}

const Kernel& widest_kernel() { return kernel_for(widest_allowed()); }

}  // namespace zproof::texture::sums
