#include "filters/reference/shared_images.h"

namespace zproof::oracle::filter_reference {

namespace {

ColourRange hull_of(const PermittedColours& candidates) {
    ColourRange all = candidates.front();
    for (const ColourRange& range : candidates) all = hull(all, range);
    return all;
}

enum class TexelFilter { nearest, bilinear };

/// The mean at the centres of n x n equal squares of the pixel.
template <TexelFilter reading>
MethodReference supersample(const texture::LinearImage& image, const Settings& settings) {
    return [level = exact_level(image, settings), settings](const FilterQuery& q) -> PermittedColours {
        const int n = settings.subdivisions;
        ColourRange sum;
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const TexelInterval at = q.seen.at(q.x + (i + 0.5) / n, q.y + (j + 0.5) / n);
                const TexelInterval place = place_in(*level, *level, at, q.precision);
                if constexpr (reading == TexelFilter::nearest)
                    sum = sum + hull_of(nearest(*level, settings.wrap, place));
                else
                    sum = sum + bilinear(*level, settings.wrap, place, q.precision);
            }
        }
        return {Interval{1.0 / (n * n)} * sum};
    };
}

}  // namespace

std::vector<Definition> supersample_definitions() {
    return {{"supersample-nearest", supersample<TexelFilter::nearest>},
            {"supersample-bilinear", supersample<TexelFilter::bilinear>}};
}

}  // namespace zproof::oracle::filter_reference
