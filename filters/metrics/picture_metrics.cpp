#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <vector>

#include "filters/metrics/metrics.h"

namespace zproof {

std::span<const PictureMetric> picture_metrics(LightRange range) {
    static const std::array metrics{rmse_metric(), psnr_metric(),  mae_metric(),   p99_metric(),
                                    max_metric(),  flip_metric(),  ssim_metric(),  bias_metric(),
                                    blur_metric(), alias_metric(), stops_metric(), flip_tone_metric()};
    constexpr std::size_t beyond_white = 2;
    const std::span<const PictureMetric> all{metrics};
    return range == LightRange::beyond_white ? all : all.first(all.size() - beyond_white);
}

const PictureMetric* find_picture_metric(std::string_view name) {
    const auto all = picture_metrics(LightRange::beyond_white);
    const auto found = std::ranges::find(all, name, &PictureMetric::name);
    return found == all.end() ? nullptr : &*found;
}

double measured(const PictureMetric& metric, const Plane<double>& map, const Plane<std::uint8_t>& mask) {
    if (map.size() != mask.size()) throw std::invalid_argument{"measured: planes of different sizes"};
    std::vector<double> values;
    for (std::size_t i = 0; i < map.pixels().size(); ++i)
        if (mask.pixels()[i] != 0) values.push_back(map.pixels()[i]);
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : metric.pool(values);
}

}  // namespace zproof
