#include "compare/first_pass/depth_histograms.h"

namespace zproof {

namespace {

using Bins = Strip::Values<std::int32_t>;
struct BinsOfBoth {
    Bins candidate, reference;
};

/// As BoundHistogram has it.
[[gnu::always_inline]] inline std::int32_t bin_of(double ratio) {
    constexpr double last = std::tuple_size_v<BoundHistogram> - 1;
    const double scaled = ratio * last;
    return std::int32_t(scaled < last ? scaled : last);
}

/// `uncounted` where not both are settled.
[[gnu::target_clones("default", "avx2", "avx512f")]] void set_bins(const Strip& strip,
                                                                   const SortedStrip::Ratios& ratio,
                                                                   std::int32_t uncounted, BinsOfBoth& bins) {
    const PrimitiveId *const ours = strip.candidate.primitive, *const theirs = strip.reference.primitive;
    for (std::size_t i = 0; i < Strip::width; ++i) {
        const double a = ratio.candidate[i], b = ratio.reference[i];
        const bool is_counted = (ours[i] == theirs[i]) & (a >= 0) & (b >= 0);
        bins.candidate[i] = is_counted ? bin_of(a) : uncounted;
        bins.reference[i] = is_counted ? bin_of(b) : uncounted;
    }
}

}  // namespace

void DepthHistograms::add(const Strip& strip, const SortedStrip::Ratios& ratio) {
    BinsOfBoth bins;
    set_bins(strip, ratio, uncounted, bins);
    for (std::size_t i = 0; i < Strip::width; ++i)
        ++pairs_[i % lanes][std::size_t(bins.candidate[i]) * stride + std::size_t(bins.reference[i])];
}

void DepthHistograms::add_to(Tally& tally) const {
    for (const auto& lane : pairs_)
        for (std::size_t a = 0; a < uncounted; ++a)
            for (std::size_t b = 0; b < uncounted; ++b) {
                const std::uint32_t pixels = lane[a * stride + b];
                tally.candidate.histogram[a] += pixels;
                tally.reference.histogram[b] += pixels;
            }
}

}  // namespace zproof
