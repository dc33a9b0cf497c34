#include "filters/study/scores.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace zproof::study {

namespace {

double half_width_of(const Plane<double>& half_width, const Region& region) {
    double squares = 0;
    for (std::size_t i = 0; i < half_width.pixels().size(); ++i)
        if (region.mask.pixels()[i] != 0) squares += half_width.pixels()[i] * half_width.pixels()[i];
    return region.pixels == 0 ? 0 : std::sqrt(squares / double(region.pixels));
}

/// Sums of squares over the channels of all masked pixels of all steps.
struct Change {
    double unwanted = 0, of_picture = 0, of_truth = 0;
    std::uint64_t channels = 0;
};

double square(const glm::dvec3& v) { return glm::dot(v, v); }

/// One view and the next.
struct Step {
    const LinearPicture &picture, &next_picture, &truth, &next_truth;
};

void add(Change& sum, const Step& step, const Plane<std::uint8_t>& mask) {
    for (std::size_t i = 0; i < mask.pixels().size(); ++i) {
        if (mask.pixels()[i] == 0) continue;
        const glm::dvec3 picture = step.next_picture.pixels()[i] - step.picture.pixels()[i],
                         truth = step.next_truth.pixels()[i] - step.truth.pixels()[i];
        sum.unwanted += square(picture - truth);
        sum.of_picture += square(picture);
        sum.of_truth += square(truth);
        sum.channels += 3;
    }
}

}  // namespace

LinearPicture in_double(const Picture& picture) {
    LinearPicture same(picture.size());
    for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
        const LinearRgb& c = picture.pixels()[i];
        same.pixels()[i] = {c.r, c.g, c.b};
    }
    return same;
}

std::vector<RegionScore> scores(const LinearPicture& picture, const LinearPicture& truth,
                                const Plane<double>& half_width, std::span<const Region> regions,
                                const Measures& measures) {
    std::vector<RegionScore> all;
    for (const Region& region : regions)
        all.push_back({region.name, region.pixels, half_width_of(half_width, region), {}});
    for (const PictureMetric& metric : measures.metrics) {
        const Plane<double> map = metric.map(picture, truth);
        if (measures.visit) measures.visit(metric, map);
        tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t i) {
            all[i].values.push_back(measured(metric, map, regions[i].mask));
        });
    }
    return all;
}

Flicker flicker(std::span<const LinearPicture> pictures, std::span<const LinearPicture> truths,
                const Plane<std::uint8_t>& mask) {
    Change sum;
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i)
        add(sum, {pictures[i], pictures[i + 1], truths[i], truths[i + 1]}, mask);
    if (sum.channels == 0) return {};
    return {.rms = std::sqrt(sum.unwanted / double(sum.channels)),
            .ratio = std::sqrt(sum.of_picture / sum.of_truth),
            .steps = int(pictures.size()) - 1};
}

}  // namespace zproof::study
