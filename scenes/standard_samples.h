/// The standard patterns of samples (docs/samples.md).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scenes/sample.h"

namespace zproof {
namespace sample_patterns {

/// In 1/16 px from the centre, x right, y down.
struct PlaceInPixel {
    int x, y;
};

// Direct3D 11's D3D11_STANDARD_MULTISAMPLE_PATTERN; Vulkan 1.3, 26.4, has the same as standard sample
// locations.
inline constexpr std::array pattern_of_1{PlaceInPixel{0, 0}};
inline constexpr std::array pattern_of_2{PlaceInPixel{4, 4}, PlaceInPixel{-4, -4}};
inline constexpr std::array pattern_of_4{PlaceInPixel{-2, -6}, PlaceInPixel{6, -2}, PlaceInPixel{-6, 2},
                                         PlaceInPixel{2, 6}};
inline constexpr std::array pattern_of_8{PlaceInPixel{1, -3},  PlaceInPixel{-1, 3}, PlaceInPixel{5, 1},
                                         PlaceInPixel{-3, -5}, PlaceInPixel{-5, 5}, PlaceInPixel{-7, -1},
                                         PlaceInPixel{3, 7},   PlaceInPixel{7, -7}};
inline constexpr std::array pattern_of_16{
    PlaceInPixel{1, 1},   PlaceInPixel{-1, -3}, PlaceInPixel{-3, 2},  PlaceInPixel{4, -1},
    PlaceInPixel{-5, -2}, PlaceInPixel{2, 5},   PlaceInPixel{5, 3},   PlaceInPixel{3, -5},
    PlaceInPixel{-2, 6},  PlaceInPixel{0, -7},  PlaceInPixel{-4, -6}, PlaceInPixel{-6, 4},
    PlaceInPixel{-8, 0},  PlaceInPixel{7, -4},  PlaceInPixel{6, 7},   PlaceInPixel{-7, -8}};

inline std::span<const PlaceInPixel> pattern_of(int count) {
    switch (count) {
        case 1:
            return pattern_of_1;
        case 2:
            return pattern_of_2;
        case 4:
            return pattern_of_4;
        case 8:
            return pattern_of_8;
        case 16:
            return pattern_of_16;
        default:
            return {};
    }
}

}  // namespace sample_patterns

/// The standard pattern of 1, 2, 4, 8 or 16 samples, in its order; empty for any other count.
inline std::vector<Sample> standard_samples(int count) {
    std::vector<Sample> samples;
    for (const sample_patterns::PlaceInPixel& place : sample_patterns::pattern_of(count))
        samples.push_back({int(samples.size()), count, glm::dvec2(place.x, place.y) / 16.0});
    return samples;
}

}  // namespace zproof
