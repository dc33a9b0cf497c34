#include <array>
#include <cmath>

#include "filters/metrics/convolution.h"
#include "filters/metrics/map.h"
#include "filters/metrics/metrics.h"
#include "math/srgb.h"

namespace zproof {

namespace {

/// Wang et al. 2004, III-C: an 11 x 11 Gaussian of 1.5 pixels, K1 = 0.01, K2 = 0.03; the range is 1.
constexpr int radius = 5;
constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;

std::vector<double> gaussian() {
    std::vector<double> taps;
    for (int i = -radius; i <= radius; ++i) taps.push_back(std::exp(-i * i / (2 * 1.5 * 1.5)));
    return normalised(taps);
}

/// Luminance (Rec. 709), sRGB-encoded.
Plane<double> luma(const LinearPicture& light) {
    return mapped(light.size(), [&](int x, int y) {
        return encoded_srgb(glm::dot(light.at(x, y), glm::dvec3{0.2126, 0.7152, 0.0722}));
    });
}

Plane<double> product(const Plane<double>& a, const Plane<double>& b) {
    return mapped(a.size(), [&](int x, int y) { return a.at(x, y) * b.at(x, y); });
}

Plane<double> ssim_map(const LinearPicture& candidate, const LinearPicture& truth) {
    require_one_size(candidate, truth);
    const std::vector<double> window = gaussian();
    const auto local_mean = [&](const Plane<double>& values) { return convolved(values, window, window); };
    const Plane<double> m = luma(candidate), r = luma(truth);
    const Plane<double> mean_m = local_mean(m), mean_r = local_mean(r), mm = local_mean(product(m, m)),
                        rr = local_mean(product(r, r)), mr = local_mean(product(m, r));
    return mapped(truth.size(), [&](int x, int y) {
        const double a = mean_m.at(x, y), b = mean_r.at(x, y);
        const double spread = mm.at(x, y) - a * a + rr.at(x, y) - b * b, shared = mr.at(x, y) - a * b;
        return (2 * a * b + c1) * (2 * shared + c2) / ((a * a + b * b + c1) * (spread + c2));
    });
}

}  // namespace

PictureMetric ssim_metric() {
    return {.name = "ssim",
            .definition =
                "Mean structural similarity of sRGB-encoded luminance, cut to [0, 1], the image "
                "continued by its border pixels.",
            .source =
                "Wang et al., Image quality assessment: from error visibility to structural "
                "similarity, IEEE TIP 2004",
            .better = Better::higher,
            .map = ssim_map,
            .pool = mean_of};
}

}  // namespace zproof
