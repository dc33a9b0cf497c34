/// Which kernels this machine can run.
#pragma once

#include <vector>

#include "filters/reads/kernel.h"

namespace zproof::texture::reads {

/// The kernels that the processor says it can run, narrowest first; scalar runs everywhere.
std::vector<Kernel> available_kernels();

/// The one for widest_allowed() (math/processor.h).
const Kernel& widest_kernel();

}  // namespace zproof::texture::reads
