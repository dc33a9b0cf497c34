/// The law's own mip chain: in double from level to level, with what rounding each level to its stored format
/// may have cost.
#pragma once

#include "oracle/filter_law/question.h"

namespace zproof::oracle::filter_law {

/// Level k + 1 has max(1, floor(size / 2)) texels on either side, down to 1 x 1. A texel's radius is
/// sum |w| radius of what it is made of, and one rounding at the unit 2^-texel_bits
/// (docs/filter-conformance.md).
std::vector<LawImage> chain(const texture::LinearImage& image, const Settings& settings, double texel_bits);

}  // namespace zproof::oracle::filter_law
