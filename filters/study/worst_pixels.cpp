#include "filters/study/worst_pixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zproof::study {

double pixel_error(const LinearRgb& picture, const LinearRgb& truth) {
    double most = 0;
    for (const double difference :
         {double(picture.r) - truth.r, double(picture.g) - truth.g, double(picture.b) - truth.b})
        most = std::isfinite(difference) ? std::max(most, std::abs(difference))
                                         : std::numeric_limits<double>::infinity();
    return most;
}

std::vector<std::vector<PixelCoord>> worst_pixels(const Picture& picture, const Picture& truth,
                                                  std::span<const Region> regions) {
    std::vector<std::vector<PixelCoord>> worst(regions.size());
    std::vector<double> most(regions.size(), -1);
    for (int y = 0; y < truth.size().height; ++y)
        for (int x = 0; x < truth.size().width; ++x) {
            const double error = pixel_error(picture.at(x, y), truth.at(x, y));
            for (std::size_t r = 0; r < regions.size(); ++r) {
                if (regions[r].mask.at(x, y) == 0 || !(error > most[r])) continue;
                most[r] = error;
                worst[r] = {{x, y}};
            }
        }
    return worst;
}

std::vector<ChosenPixels> chosen_pixels(std::span<const MethodPixels> methods, std::size_t most) {
    std::vector<ChosenPixels> chosen;
    std::size_t regions = 0, count = 0;
    for (const MethodPixels& method : methods) {
        chosen.push_back({method.label, {}});
        regions = std::max(regions, method.by_region.size());
    }
    const auto is_known = [](const ChosenPixels& of, const PixelCoord& p) {
        return std::ranges::any_of(of.pixels, [&](const PixelCoord& q) { return q.x == p.x && q.y == p.y; });
    };
    for (std::size_t r = 0; r < regions; ++r)
        for (std::size_t m = 0; m < methods.size(); ++m)
            for (const PixelCoord& pixel : methods[m].by_region[r]) {
                if (count == most || is_known(chosen[m], pixel)) continue;
                chosen[m].pixels.push_back(pixel);
                ++count;
            }
    for (ChosenPixels& of : chosen)
        std::ranges::sort(of.pixels, {}, [](const PixelCoord& p) { return std::pair{p.y, p.x}; });
    return chosen;
}

}  // namespace zproof::study
