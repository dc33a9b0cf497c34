#include "scenes/sample.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace zproof {
namespace {

bool is_sample_offset(double offset_px) {
    return offset_px >= -0.5 && offset_px < 0.5 && std::nearbyint(offset_px * 256) == offset_px * 256;
}

}  // namespace

bool is_sample_offset(const glm::dvec2& offset_px) {
    return is_sample_offset(offset_px.x) && is_sample_offset(offset_px.y);
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
