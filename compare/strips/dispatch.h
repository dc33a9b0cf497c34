/// Which kernels this machine can run.
#pragma once

#include <vector>

#include "compare/strips/kernel.h"

namespace zproof::strips {

/// By what the processor says of itself, narrowest first: scalar is everywhere.
std::vector<Kernel> available_kernels();

/// The last of them. Asked once.
const Kernel& widest_kernel();

}  // namespace zproof::strips
