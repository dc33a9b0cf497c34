/// The parts of an image on which a filter is held to the truth apart from the rest.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "filters/area/area_integral.h"
#include "filters/study/results.h"
#include "filters/study/surface_map.h"

namespace zproof::study {

struct Region {
    std::string name;
    Plane<std::uint8_t> mask;  ///< 1: belongs to it
    std::uint64_t pixels = 0;
};

/// Names and definitions, in the order of regions(): all, interior, silhouette, sampled, magnified, horizon,
/// the classes of anisotropy, the angles.
std::vector<RegionCard> region_cards();

/// Every region of the view, empty ones as well: by the surfaces around each pixel (oracle::surfaces_around),
/// and by whether its truth is exact. But for `sampled`, no region depends on the truth. Planes of one size.
std::vector<Region> regions(const Plane<Patch>& patches, const Plane<oracle::TruthKind>& around,
                            const Plane<oracle::TruthKind>& truth);

/// A word per pixel: bit i is set where the pixel belongs to region i. At most 32 regions.
Plane<std::uint32_t> region_bits(std::span<const Region> regions);

}  // namespace zproof::study
