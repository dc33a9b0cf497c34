/// The filter reference's own mip chain: in double from level to level, with what rounding each level to its
/// stored format may have cost.
#pragma once

#include <vector>

#include "filters/reference/filter_query.h"

namespace zproof::oracle::filter_reference {

inline int half_of(int size) { return size > 1 ? size / 2 : 1; }

/// What a texel of the coarser level is made of along one axis.
struct Source {
    int index = 0;
    double weight = 0;
};
using Sources = std::vector<Source>;

/// How one axis shrinks.
struct Axis {
    int fine = 1, coarse = 1;
    Wrap wrap = Wrap::repeat;
};

/// The sources of every texel of the coarser level.
std::vector<Sources> all_sources(ChainKernel kernel, const Axis& axis);

/// What rounding a level to what it is kept as may cost: relative, and the least.
struct StoredUnit {
    double relative, least;
};
/// What has fewer bits than float32 may be float16.
StoredUnit stored_unit(double texel_bits);

/// The sum over the sources, as a stored texel.
IntervalImage::Texel made_of(const IntervalImage& finer, const Sources& columns, const Sources& rows,
                             const StoredUnit& unit);

/// A smaller image made of a larger one, either axis halved or kept. A texel's radius is sum |w| radius of
/// what it is made of, and one rounding to float32 (docs/filter-conformance.md).
IntervalImage shrunk(const IntervalImage& finer, int width, int height, const Settings& settings);

/// Level k + 1 has max(1, floor(size / 2)) texels on either side, down to 1 x 1. Levels that are given are
/// exact.
std::vector<IntervalImage> chain(const texture::LinearImage& image, const Settings& settings);

/// The chain whose texels are weighed by the surfaces' area that they cover; where no surface is known, as
/// chain().
std::vector<IntervalImage> chain_by_area(const texture::LinearImage& image, const Settings& settings);

}  // namespace zproof::oracle::filter_reference
