/// A picture held to the truth: every metric in every region, and the flicker of a few views.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "filters/metrics/picture_metric.h"
#include "filters/study/regions.h"
#include "filters/study/results.h"
#include "frame/picture.h"

namespace zproof::study {

/// The picture's float32 channels as doubles.
LinearPicture in_double(const Picture& picture);

/// What is measured.
struct Measures {
    std::span<const PictureMetric> metrics = picture_metrics();
    /// Is told every metric's values, pixel by pixel; empty: nobody is.
    std::function<void(const PictureMetric&, const Plane<double>&)> visit{};
};

/// Every metric for every region, in order. `half_width` is the truth's.
std::vector<RegionScore> scores(const LinearPicture& picture, const LinearPicture& truth,
                                const Plane<double>& half_width, std::span<const Region> regions,
                                const Measures& measures = {});

/// The flicker of pictures and truths of the same views, one after the other, over the pixels where the mask
/// is not 0. There are no steps where there are fewer than two views or no pixel.
Flicker flicker(std::span<const LinearPicture> pictures, std::span<const LinearPicture> truths,
                const Plane<std::uint8_t>& mask);

}  // namespace zproof::study
