// The exact mean against POV-Ray's pictures with many samples per pixel.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/povray.h"
#include "tests/oracle/scenes_at_random.h"
#include "textured_plane.h"
#include "weight_at.h"

namespace zproof::oracle {

namespace {

constexpr int side = 6, replicates = 6;     ///< samples per pixel and axis; shifts of their grid
constexpr double student_5 = 2.5705818356;  ///< t of 5 degrees of freedom, two-sided 95 %

/// side x side samples per pixel, each at its cell's centre plus the shift (in cells, less than 1/2).
Picture samples(const PovRay& povray, View view, const glm::dvec2& shift) {
    view.width *= side, view.height *= side;
    Window& w = view.camera.window;
    const double right = shift.x * (w.right - w.left) / view.width,
                 down = shift.y * (w.top - w.bottom) / view.height;
    w = {w.left + right, w.right + right, w.bottom - down, w.top - down};
    return povray.picture(view, Light{.ambient = 1, .diffuse = 0});
}

/// The weighted mean of green around a pixel that has all it looks at in the picture: every sample is uniform
/// in its cell.
double weighted(const Picture& picture, const glm::ivec2& pixel, const glm::dvec2& shift,
                const area::PixelWeight& weight) {
    const int reach = int(std::lround((weight.half_side + 0.5) * side));
    const glm::ivec2 middle = pixel * side + side / 2;
    double sum = 0, total = 0;
    for (int dy = -reach; dy < reach; ++dy)
        for (int dx = -reach; dx < reach; ++dx) {
            const glm::dvec2 offset = (glm::dvec2(dx, dy) + 0.5 + shift) / double(side);
            if (std::max(std::abs(offset.x), std::abs(offset.y)) > weight.half_side) continue;
            const double counts = area::weight_at(weight, offset.x, offset.y);
            sum += counts * double(picture.at(middle.x + dx, middle.y + dy).g);
            total += counts;
        }
    return sum / total;
}

/// (exact - mean of the replicates) and half its interval, for one channel of a pixel.
struct Comparison {
    double difference = 0, half_width = 0;
};

Comparison compared(double exact, const std::array<double, replicates>& values) {
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / replicates;
    for (const double v : values) squares += (v - mean) * (v - mean);
    constexpr double code_step = 0.5 / 65535;  // of a channel
    return {exact - mean, student_5 * std::sqrt(squares / (replicates * (replicates - 1))) + code_step};
}

class WithPovRay : public testing::TestWithParam<NamedReconstruction> {};
INSTANTIATE_TEST_SUITE_P(AreaIntegral, WithPovRay, testing::ValuesIn(reconstructions),
                         [](const auto& named) { return std::string{named.param.letters}; });

TEST_P(WithPovRay, LiesWithinTheIntervalOfItsPictures) {
    const Reconstruction what = GetParam().reconstruction;
    Scene scene = textured_plane(
        64, {.image = noise(37, 23, 5), .per_unit = 0.11, .phi_degrees = 25, .offset = {0.3, 0.71}});
    if (is_of_nearest(what)) scene.materials[0].base_color.sampler.magnification = Magnification::nearest;
    const View view = ground_view(24, 18, 20);
    const AreaTruth exact = area_truth(scene, view, what);
    const area::PixelWeight& weight = area::weight_of(what);
    Rng rng(11);
    std::array<glm::dvec2, replicates> shifts;
    std::array<Picture, replicates> pictures;
    for (std::size_t i = 0; i < replicates; ++i) {
        const double right = rng.between(-0.5, 0.5), down = rng.between(-0.5, 0.5);
        shifts[i] = {right, down};
        pictures[i] = samples(PovRay(scene), view, shifts[i]);
    }
    const int margin = int(std::ceil(weight.half_side));
    int count = 0, outside = 0;
    double sum = 0, squares = 0;
    for (int y = margin; y < view.height - margin; ++y)
        for (int x = margin; x < view.width - margin; ++x) {
            if (exact.kind.at(x, y) == TruthKind::background) continue;
            std::array<double, replicates> values{};
            for (std::size_t i = 0; i < replicates; ++i)
                values[i] = weighted(pictures[i], {x, y}, shifts[i], weight);
            const Comparison c = compared(exact.mean.at(x, y).g, values);
            ++count;
            outside += std::abs(c.difference) > c.half_width;
            sum += c.difference;
            squares += c.difference * c.difference;
        }
    EXPECT_GT(count, 200);
    EXPECT_LT(outside, 0.1 * count);
    EXPECT_LT(std::abs(sum), 4 * std::sqrt(squares));
}

}  // namespace

}  // namespace zproof::oracle
