#include "scenes/sample.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <span>
#include <sstream>

namespace zproof {
namespace {

/// In 1/16 px from the centre, x right, y down.
struct Place {
    int x, y;
};

// Direct3D 11's D3D11_STANDARD_MULTISAMPLE_PATTERN; Vulkan 1.3, 26.4, has the same as standard sample
// locations.
constexpr std::array pattern_of_1{Place{0, 0}};
constexpr std::array pattern_of_2{Place{4, 4}, Place{-4, -4}};
constexpr std::array pattern_of_4{Place{-2, -6}, Place{6, -2}, Place{-6, 2}, Place{2, 6}};
constexpr std::array pattern_of_8{Place{1, -3}, Place{-1, 3},  Place{5, 1}, Place{-3, -5},
                                  Place{-5, 5}, Place{-7, -1}, Place{3, 7}, Place{7, -7}};
constexpr std::array pattern_of_16{Place{1, 1},   Place{-1, -3}, Place{-3, 2},  Place{4, -1},
                                   Place{-5, -2}, Place{2, 5},   Place{5, 3},   Place{3, -5},
                                   Place{-2, 6},  Place{0, -7},  Place{-4, -6}, Place{-6, 4},
                                   Place{-8, 0},  Place{7, -4},  Place{6, 7},   Place{-7, -8}};

std::span<const Place> pattern_of(int count) {
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

bool is_sample_offset(double offset_px) {
    return offset_px >= -0.5 && offset_px < 0.5 && std::nearbyint(offset_px * 256) == offset_px * 256;
}

}  // namespace

bool is_sample_offset(const glm::dvec2& offset_px) {
    return is_sample_offset(offset_px.x) && is_sample_offset(offset_px.y);
}

std::vector<Sample> standard_samples(int count) {
    std::vector<Sample> samples;
    for (const Place& place : pattern_of(count))
        samples.push_back({int(samples.size()), count, glm::dvec2(place.x, place.y) / 16.0});
    return samples;
}

std::string px_text(double offset_px) {
    std::ostringstream text;
    text << std::setprecision(9) << offset_px;  // 1/256 and its multiples have 8 at most
    return text.str();
}

std::string sample_word(const Sample& sample) {
    if (sample.count > 1)
        return "standard:" + std::to_string(sample.count) + ":" + std::to_string(sample.index);
    if (sample.offset_px == glm::dvec2(0)) return "";
    return px_text(sample.offset_px.x) + "," + px_text(sample.offset_px.y);
}

}  // namespace zproof
