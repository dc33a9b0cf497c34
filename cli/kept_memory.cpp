#include "cli/kept_memory.h"

#include <malloc.h>

#include <limits>

namespace zproof {

void keep_freed_memory() noexcept {
#ifdef __GLIBC__
    constexpr int most = std::numeric_limits<int>::max();
    mallopt(M_MMAP_THRESHOLD, most);
    mallopt(M_TRIM_THRESHOLD, most);
#endif
}

}  // namespace zproof
