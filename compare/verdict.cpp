#include "compare/verdict.h"

#include <algorithm>

namespace zproof {

void count(BoundRecord& record, double error_over_bound) {
    constexpr int last_bin = std::tuple_size_v<BoundHistogram> - 1;
    record.max_error_over_bound = std::max(record.max_error_over_bound, error_over_bound);
    const double bin = std::min(error_over_bound * last_bin, double(last_bin));
    ++record.histogram[bin >= 0 ? std::size_t(bin) : last_bin];
}

void add(BoundRecord& sum, const BoundRecord& part) {
    sum.max_error_over_bound = std::max(sum.max_error_over_bound, part.max_error_over_bound);
    for (std::size_t i = 0; i < sum.histogram.size(); ++i) sum.histogram[i] += part.histogram[i];
}

std::uint64_t defect_count(const Verdict& verdict) {
    std::uint64_t defects = 0;
    for (int c = 0; c < pixel_class_count; ++c)
        if (is_defect(PixelClass(c))) defects += verdict.counts[std::size_t(c)];
    return defects;
}

}  // namespace zproof
