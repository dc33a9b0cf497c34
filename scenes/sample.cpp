#include "scenes/sample.h"

#include <cmath>

#include "frame/number_text.h"

namespace zproof {
namespace {

bool is_sample_offset(double offset_px) {
    return offset_px >= -0.5 && offset_px < 0.5 && std::nearbyint(offset_px * 256) == offset_px * 256;
}

}  // namespace

bool is_sample_offset(const glm::dvec2& offset_px) {
    return is_sample_offset(offset_px.x) && is_sample_offset(offset_px.y);
}

/// Multiples of 1/256 have 8 digits at most.
std::string px_text(double offset_px) { return with_digits(offset_px, 9); }

std::string sample_word(const Sample& sample) {
    if (sample.count > 1)
        return "standard:" + std::to_string(sample.count) + ":" + std::to_string(sample.index);
    if (sample.offset_px == glm::dvec2(0)) return "";
    return px_text(sample.offset_px.x) + "," + px_text(sample.offset_px.y);
}

}  // namespace zproof
