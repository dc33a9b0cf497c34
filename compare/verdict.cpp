#include "compare/verdict.h"

namespace zproof {

std::uint64_t defect_count(const Verdict& verdict) {
    std::uint64_t defects = 0;
    for (int c = 0; c < pixel_class_count; ++c)
        if (is_defect(PixelClass(c))) defects += verdict.counts[std::size_t(c)];
    return defects;
}

}  // namespace zproof
