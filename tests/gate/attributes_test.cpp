/// Attributes before the judge: perspective-correct ones are within their bounds, affine ones are not.
#include <gtest/gtest.h>

#include <cmath>

#include "compare/attributes/attribute_check.h"
#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/interpolation.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

constexpr int width = 160, height = 90;

class AttributesOf : public testing::TestWithParam<std::string> {
  protected:
    Loaded loaded = generate_suite_scene(GetParam(), width, height);

    /// Pixels of a view with a wrong value.
    int wrong_in(const View& view, const Frame& frame, const Precision& precision) const {
        const ViewBounds bounds(view, precision);
        const AttributeCheck check(loaded.scene, view, bounds, precision);
        int wrong = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (const auto found = check.first_wrong(frame, {x, y})) {
                    if (++wrong == 1)
                        first_ = std::to_string(x) + ", " + std::to_string(y) + ": " + found->channel +
                                 " is " + std::to_string(found->value) + ", admissible " +
                                 std::to_string(found->low) + " to " + std::to_string(found->high);
                }
        return wrong;
    }

    mutable std::string first_;  ///< wrong value, in words
};

TEST_P(AttributesOf, ACorrectFrameAreWithinTheirBounds) {
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        Frame frame = rasterizer::render(loaded.scene, view);
        frame.attributes = rasterizer::attributes_of(loaded.scene, view, frame);
        EXPECT_EQ(wrong_in(view, frame, rasterizer::precision()), 0) << first_;
    }
}

TEST_P(AttributesOf, AnAffineInterpolationAreFoundWrong) {
    int wrong = 0;
    for (const View& view : loaded.views) {
        Frame frame = rasterizer::render(loaded.scene, view);
        frame.attributes =
            rasterizer::attributes_of(loaded.scene, view, frame, rasterizer::Interpolation::affine);
        wrong += wrong_in(view, frame, rasterizer::precision());
    }
    EXPECT_GT(wrong, 1000);
}

/// A value at the end of its bound passes; one step of 1/1000 of the bound beyond fails.
TEST_P(AttributesOf, APixelMayUseAllOfTheBoundAndNoMore) {
    const View& view = loaded.views.front();
    Frame frame = rasterizer::render(loaded.scene, view);
    frame.attributes = rasterizer::attributes_of(loaded.scene, view, frame);
    const Precision precision = rasterizer::precision();
    const ViewBounds bounds(view, precision);
    const AttributeCheck check(loaded.scene, view, bounds, precision);
    int tried = 0;
    for (int y = 5; y < height; y += 10)
        for (int x = 5; x < width; x += 10) {
            if (frame.primitive.at(x, y) == PrimitiveId::none) continue;
            float& b1 = frame.attributes.barycentric.at(x, y)[0];
            const float right = b1;
            b1 = 7;
            const auto wrong = check.first_wrong(frame, {x, y});
            b1 = right;
            if (!wrong) continue;
            const double room = wrong->high - wrong->low;
            ++tried;
            b1 = std::nextafter(float(wrong->high), 0.0f);
            EXPECT_FALSE(check.first_wrong(frame, {x, y})) << x << ", " << y;
            b1 = std::nextafter(float(wrong->high + 0.001 * room), 2.0f);
            EXPECT_TRUE(check.first_wrong(frame, {x, y})) << x << ", " << y;
            b1 = std::nextafter(float(wrong->low - 0.001 * room), -2.0f);
            EXPECT_TRUE(check.first_wrong(frame, {x, y})) << x << ", " << y;
            b1 = right;
        }
    EXPECT_GT(tried, 20);
}

INSTANTIATE_TEST_SUITE_P(Suite, AttributesOf,
                         testing::Values("room", "textured_ground", "near_plane", "shared_edges"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
