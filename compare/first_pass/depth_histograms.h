/// How errors of depth are distributed over their bounds, counted strip by strip.
#pragma once

#include "compare/first_pass/agreement.h"
#include "compare/strips/strip.h"

namespace zproof {

/// Both renderers' depths are counted as one, where both name the same triangle and both are lawful for
/// certain: histograms are the sums of those pairs. Neighbouring pixels often fall into the same: they are
/// counted side by side. At most 2^32 pixels in all.
class DepthHistograms {
  public:
    /// All ratios of a strip.
    void add(const Strip& strip, const SortedStrip::Ratios& ratio);
    void add_to(Tally& tally) const;

  private:
    static constexpr std::size_t uncounted = std::tuple_size_v<BoundHistogram>;
    static constexpr std::size_t lanes = 4;
    static constexpr std::size_t stride = 32;  ///< a power of two above `uncounted`

    std::array<std::array<std::uint32_t, (uncounted + 1) * stride>, lanes> pairs_{};
};

}  // namespace zproof
