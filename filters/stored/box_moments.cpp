#include "filters/stored/box_moments.h"

namespace zproof::texture {

namespace {

LinearImage squared(LinearImage image) {
    for (glm::vec4& texel : image.texels) texel *= texel;
    return image;
}

}  // namespace

MomentTables::MomentTables(const LinearImage& image, const Addressing& addressing, SatStorage storage)
    : addressing_{addressing}, texels_{image, storage}, squares_{squared(image), storage} {}

Moments MomentTables::over(const Extent& columns, const Extent& rows) const {
    const Parts<Run> across = covered(columns, addressing_.u, texels_.width()),
                     down = covered(rows, addressing_.v, texels_.height());
    const glm::dvec4 mean = texels_.mean(across, down);
    return {mean, glm::max(squares_.mean(across, down) - mean * mean, 0.0)};
}

double most_at_or_above(double mean, double variance, double t) {
    if (t <= mean) return 1;
    return variance / (variance + (t - mean) * (t - mean));
}

}  // namespace zproof::texture
