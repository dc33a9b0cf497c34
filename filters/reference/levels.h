/// Reading a mip chain at places and levels that are known within intervals.
#pragma once

#include "filters/reference/chain.h"
#include "filters/reference/lod.h"
#include "filters/reference/shared_images.h"

namespace zproof::oracle::filter_reference {

class Levels {
  public:
    Levels(const texture::LinearImage& image, const Settings& settings);
    Levels(std::vector<IntervalImage> levels, const Settings& settings);

    std::size_t count() const { return levels_->size(); }
    const IntervalImage& at(int level) const { return (*levels_)[std::size_t(level)]; }
    const Settings& settings() const { return settings_; }

    PermittedColours nearest_in(int level, const TexelInterval& place,
                                const FilterPrecision& precision) const;
    ColourRange bilinear_in(int level, const TexelInterval& place, const FilterPrecision& precision) const;
    /// Bilinear in the two levels around the LOD, blended by its fraction; the LOD within [0, count - 1].
    ColourRange trilinear(const Interval& level, const TexelInterval& place,
                          const FilterPrecision& precision) const;

  private:
    glm::dvec3 cost_of_splits_in(int level, const TexelInterval& place,
                                 const FilterPrecision& precision) const;

    Settings settings_;
    Chain levels_;
};

/// A definition over a mip chain: the chain is made once.
std::function<MethodReference(const texture::LinearImage&, const Settings&)> over_levels(
    std::function<PermittedColours(const Levels&, const FilterQuery&)> reference);

}  // namespace zproof::oracle::filter_reference
