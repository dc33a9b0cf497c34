/// Pixels that are made of several samples: depths resolved to one, ids that were averaged.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/reports_from_the_field/field_frames.h"
#include "tests/reports_from_the_field/field_scenes.h"
#include "tests/reports_from_the_field/ray_caster.h"

namespace zproof::field_reports {

namespace {

using Places = std::vector<glm::dvec2>;  ///< in the pixel, px from its centre

/// The standard patterns of Direct3D 11 and Vulkan.
const Places four{{-0.125, -0.375}, {0.375, -0.125}, {-0.375, 0.125}, {0.125, 0.375}};
const Places eight{{1.0 / 16, -3.0 / 16},  {-1.0 / 16, 3.0 / 16}, {5.0 / 16, 1.0 / 16},
                   {-3.0 / 16, -5.0 / 16}, {-5.0 / 16, 5.0 / 16}, {-7.0 / 16, -1.0 / 16},
                   {3.0 / 16, 7.0 / 16},   {7.0 / 16, -7.0 / 16}};

Places grid(int n) {
    Places places;
    for (int k = 0; k < n * n; ++k) places.push_back((glm::dvec2(k % n, k / n) + 0.5) / double(n) - 0.5);
    return places;
}

std::vector<Frame> cast_at(const Scene& scene, const View& view, const Places& places) {
    std::vector<Frame> frames;
    for (const glm::dvec2& place : places) {
        View beside = view;
        beside.sample.offset_px = place;
        frames.push_back(cast(scene, beside));
    }
    return frames;
}

/// Centres' ids; the depths of the samples that show a triangle are made one.
std::function<Shown()> resolving(const View& view, const Places& places,
                                 const std::function<double(const std::vector<double>&)>& resolve) {
    return [=] {
        const Scene scene = yard();
        Frame frame = cast(scene, view);
        const std::vector<Frame> samples = cast_at(scene, view, places);
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                std::vector<double> depths;
                for (const Frame& sample : samples)
                    if (sample.camera_depth.at(x, y) != background_depth)
                        depths.push_back(double(sample.camera_depth.at(x, y)));
                if (!depths.empty()) frame.camera_depth.at(x, y) = float(resolve(depths));
            }
        return Shown{scene, view, frame};
    };
}

double mean(const std::vector<double>& depths) {
    double sum = 0;
    for (const double depth : depths) sum += depth;
    return sum / double(depths.size());
}

double mean_of_z(const std::vector<double>& depths) {
    double sum = 0;
    for (const double depth : depths) sum += 1 / depth;
    return double(depths.size()) / sum;
}

/// Ids of samples, averaged byte by byte or as numbers; depths are the centres'.
std::function<Shown()> blending(bool by_bytes, const Places& places) {
    return [=] {
        const Scene scene = yard();
        const View view = view_of_yard();
        Frame frame = cast(scene, view);
        const std::vector<Frame> samples = cast_at(scene, view, places);
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                double number = 0;
                std::array<double, 4> bytes{};
                bool is_inside = true;
                for (const Frame& sample : samples) {
                    const auto id = std::uint32_t(sample.primitive.at(x, y));
                    is_inside &= sample.primitive.at(x, y) != PrimitiveId::none;
                    number += id / double(samples.size());
                    for (int k = 0; k < 4; ++k)
                        bytes[std::size_t(k)] += (id >> 8 * k & 0xFF) / double(samples.size());
                }
                std::uint32_t told = 0;
                for (int k = 0; k < 4; ++k) told |= std::uint32_t(std::round(bytes[std::size_t(k)])) << 8 * k;
                if (!by_bytes && !is_inside) continue;
                frame.primitive.at(x, y) = PrimitiveId(by_bytes ? told : std::uint32_t(std::round(number)));
            }
        return Shown{scene, view, frame};
    };
}

}  // namespace

std::vector<FieldFrame> frames_of_resolves() {
    const View view = view_of_yard();
    const auto least = [](const std::vector<double>& depths) { return std::ranges::min(depths); };
    const auto greatest = [](const std::vector<double>& depths) { return std::ranges::max(depths); };
    const RayPrecision ray{.arithmetic = Arithmetic::float32};
    return {
        {"resolved_to_the_least",
         {"depth is the least of 4 samples"},
         "VK_RESOLVE_MODE_MIN_BIT of a depth attachment",
         resolving(view, four, least)},
        {"resolved_to_the_greatest",
         {"depth is the greatest of 8 samples"},
         "VK_RESOLVE_MODE_MAX_BIT of a depth attachment",
         resolving(view, eight, greatest)},
        {"resolved_to_the_mean",
         {"depth is the mean of 4 samples"},
         "VK_RESOLVE_MODE_AVERAGE_BIT of a depth that is written as a colour",
         resolving(view, four, mean)},
        {"resolved_to_the_mean_of_a_caster",
         {"depth is the mean of 8 samples"},
         "the same, of a renderer that declares rays",
         resolving(view, eight, mean),
         ray},
        {"resolved_to_the_mean_of_z",
         {"depth is the mean z of 4 samples"},
         "VK_RESOLVE_MODE_AVERAGE_BIT of a depth buffer",
         resolving(view, four, mean_of_z)},
        {"resolved_to_sample_0",
         {"depth is the first of 4 samples"},
         "VK_RESOLVE_MODE_SAMPLE_ZERO_BIT of a depth attachment",
         resolving(view, four, [](const std::vector<double>& depths) { return depths.front(); })},
        {"drawn_twice_as_large",
         {"depth is averaged over the pixel"},
         "a picture that is drawn larger and made smaller",
         resolving(view, grid(2), mean)},
        {"averaged_over_the_pixel",
         {"depth is averaged over the pixel"},
         "a box filter over the film's samples",
         resolving(view, grid(8), mean)},
        {"ids_averaged_as_bytes",
         {"ids are blended by antialiasing"},
         "multisampling left on for an id target of four bytes",
         blending(true, four)},
        {"ids_averaged_as_numbers",
         {"ids are blended by antialiasing"},
         "a filter of the film over an id channel of floats",
         blending(false, grid(4))},
    };
}

}  // namespace zproof::field_reports
