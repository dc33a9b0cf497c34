/// The filter reference's own mip chain: in double from level to level, with what rounding each level to its
/// stored format may have cost.
#pragma once

#include "oracle/filter_reference/filter_query.h"

namespace zproof::oracle::filter_reference {

inline int half_of(int size) { return size > 1 ? size / 2 : 1; }

/// A smaller image made of a larger one, either axis halved or kept. A texel's radius is sum |w| radius of
/// what it is made of, and one rounding to float32 (docs/filter-conformance.md).
IntervalImage shrunk(const IntervalImage& finer, int width, int height, const Settings& settings);

/// Level k + 1 has max(1, floor(size / 2)) texels on either side, down to 1 x 1. Levels that are given are
/// exact.
std::vector<IntervalImage> chain(const texture::LinearImage& image, const Settings& settings);

}  // namespace zproof::oracle::filter_reference
