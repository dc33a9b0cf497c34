/// Vulkan before the judge: as the candidate over the whole suite, small, with every way to hold depth on
/// some of it, and as the oracle against our own. Its promise is what its device's limits say, and no less
/// would do.
#include "oracle/vulkan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "compare/attributes/attribute_check.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/standard_samples.h"
#include "scenes/suite.h"
#include "tests/gate/suite_verdict.h"
#include "tests/oracle/validated_vulkan.h"

namespace zproof {
namespace {

constexpr int width = 320, height = 180;

/// A scene's views as the device draws them, each judged by a promise, and by Embree.
std::vector<SuiteVerdict> verdicts(const std::string& scene, const oracle::VulkanSettings& settings,
                                   const Precision& precision, const Sample& sample = {}) {
    const Loaded loaded = generate_suite_scene(scene, width, height);
    const oracle::Embree embree(loaded.scene);
    const oracle::Vulkan vulkan(loaded.scene, oracle::VulkanDriver(settings));
    std::vector<SuiteVerdict> all;
    for (View view : loaded.views) {
        view.sample = sample;
        all.push_back({view.name, judge(loaded.scene, view, {vulkan.render(view), precision},
                                        {embree.trace(view), oracle::embree_precision()})});
    }
    return all;
}

void expect_proven(const std::vector<SuiteVerdict>& all) {
    for (const auto& [name, verdict] : all) {
        SCOPED_TRACE(name);
        EXPECT_EQ(defect_count(verdict), 0u) << name_of(commonest_defect(verdict));
        EXPECT_EQ(verdict.reference_defects, 0u);
        EXPECT_LE(verdict.candidate_depth.max_error_over_bound, 1);
    }
}

Precision promise(const oracle::VulkanSettings& settings) {
    return oracle::VulkanDriver(settings).precision();
}

class VulkanOnSuite : public oracle::ValidatedVulkan, public testing::WithParamInterface<std::string> {};

TEST_P(VulkanOnSuite, HasNoUnexplainedPixelAndKeepsItsDepthBounds) {
    expect_proven(verdicts(GetParam(), {}, promise({})));
}

std::vector<std::string> vulkan_scene_names() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Suite, VulkanOnSuite, testing::ValuesIn(vulkan_scene_names()),
                         [](const auto& scene) { return scene.param; });

struct DepthCase {
    std::string name;
    oracle::VulkanSettings settings;
};

class VulkanDepth : public oracle::ValidatedVulkan, public testing::WithParamInterface<DepthCase> {};

/// What lies at infinity has the value that the buffer is cleared to.
TEST_P(VulkanDepth, IsWithinItsBoundsHoweverItIsHeld) {
    const oracle::VulkanSettings& settings = GetParam().settings;
    for (const char* scene : {"room", "near_plane", "orthographic", "depth_range", "far_at_infinity"}) {
        SCOPED_TRACE(scene);
        expect_proven(verdicts(scene, settings, promise(settings)));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Buffers, VulkanDepth,
    testing::Values(DepthCase{"float32_standard", {.depth_buffer = DepthBuffer::standard_z}},
                    DepthCase{"float32_clamped", {.planes = oracle::PlanesBy::distances}},
                    DepthCase{"unorm24", {.depth_format = DepthFormat::unorm24}},
                    DepthCase{"unorm24_standard_clamped",
                              {.depth_format = DepthFormat::unorm24,
                               .depth_buffer = DepthBuffer::standard_z,
                               .planes = oracle::PlanesBy::distances}},
                    DepthCase{"unorm16", {.depth_format = DepthFormat::unorm16}},
                    DepthCase{
                        "unorm16_standard",
                        {.depth_format = DepthFormat::unorm16, .depth_buffer = DepthBuffer::standard_z}}),
    [](const auto& depth) { return depth.param.name; });

using VulkanSamples = oracle::ValidatedVulkan;

TEST_F(VulkanSamples, OfOneMultisampledTargetAreProven) {
    for (const Sample& sample : standard_samples(4)) {
        SCOPED_TRACE(sample.index);
        expect_proven(verdicts("room", {}, promise({}), sample));
    }
}

struct AttributeCase {
    std::string scene;
    double seen;  ///< the least share of wrong values that must be
    oracle::VulkanSettings settings{};
};

class VulkanAttributes : public oracle::ValidatedVulkan, public testing::WithParamInterface<AttributeCase> {
  protected:
    static oracle::VulkanSettings with_attributes(oracle::VulkanSettings settings) {
        settings.attributes = oracle::Values::all;
        return settings;
    }

    const oracle::VulkanSettings settings = with_attributes(GetParam().settings);
    const Precision precision = promise(settings);
    const Loaded loaded = with_values(generate_suite_scene(GetParam().scene, width, height));
    const oracle::Embree embree{loaded.scene};

    /// With uv and normals of their own for every vertex.
    static Loaded with_values(Loaded loaded) {
        Vertices& v = loaded.scene.vertices;
        v.uv.assign(1, {});
        v.normal_world.clear();
        for (const glm::vec3& p : v.position_world) {
            v.uv[0].emplace_back(p.x / 4, p.y / 4 + p.z / 8);
            v.normal_world.push_back(normalize(p + glm::vec3(1, 200, 3)));
        }
        return loaded;
    }
    std::uint64_t wrong_in(const View& view, const Frame& frame) const {
        const Verdict verdict =
            judge(loaded.scene, view, {frame, precision}, {embree.trace(view), oracle::embree_precision()});
        EXPECT_EQ(defect_count(verdict), verdict.counts[std::size_t(PixelClass::wrong_attribute)]);
        return defect_count(verdict);
    }
};

/// Pixels all over the image have 0.1 and a tenth more. That is wrong but where a corner's value is a million
/// times as large: of triangles that reach far.
TEST_P(VulkanAttributes, AreWithinTheirBoundsAndWrongOnesAreNot) {
    const oracle::Vulkan vulkan(loaded.scene, oracle::VulkanDriver(settings));
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        const Frame frame = vulkan.render(view);
        EXPECT_EQ(wrong_in(view, frame), 0u);
        EXPECT_EQ(judged_attributes(loaded.scene, view, frame.attributes, precision).size(), 4u);
        for (std::size_t channel = 0; channel < attribute_channels.size(); ++channel) {
            SCOPED_TRACE(attribute_channels[channel].name);
            Frame wrong = frame;
            std::uint64_t changed = 0;
            for (std::size_t i = 0; i < frame.primitive.pixels().size(); i += 97) {
                if (frame.primitive.pixels()[i] == PrimitiveId::none) continue;
                float& value = wrong.attributes.planes[channel].pixels()[i];
                value += 0.1f + 0.1f * std::abs(value);
                ++changed;
            }
            EXPECT_GE(double(wrong_in(view, wrong)), GetParam().seen * double(changed));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Suite, VulkanAttributes,
                         testing::Values(AttributeCase{"room", 1}, AttributeCase{"near_plane", 0.5},
                                         AttributeCase{"textured_ground", 0.5},
                                         AttributeCase{"orthographic", 1},
                                         AttributeCase{"frustum_cuts",
                                                       0.97,
                                                       {.depth_format = DepthFormat::unorm16,
                                                        .depth_buffer = DepthBuffer::standard_z,
                                                        .planes = oracle::PlanesBy::distances}}),
                         [](const auto& attributes) { return attributes.param.scene; });

/// A promise that says more than the device's limits do, and a scene that shows it.
struct FalsePromise {
    std::string name, scene;
    oracle::VulkanSettings settings;
    std::function<void(RasterPrecision&)> change;
    PixelClass expected;
};

class VulkanPromise : public oracle::ValidatedVulkan, public testing::WithParamInterface<FalsePromise> {};

TEST_P(VulkanPromise, IsRedWhereItSaysMoreThanTheDeviceDoes) {
    const FalsePromise& lie = GetParam();
    auto precision = std::get<RasterPrecision>(promise(lie.settings));
    lie.change(precision);
    std::size_t found = 0;
    for (const auto& [name, verdict] : verdicts(lie.scene, lie.settings, precision))
        found += verdict.counts[std::size_t(lie.expected)];
    EXPECT_GT(found, 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Lies, VulkanPromise,
    testing::Values(FalsePromise{"one_subpixel_bit_more",
                                 "closed_surfaces",
                                 {},
                                 [](RasterPrecision& p) { ++p.subpixel_bits; },
                                 PixelClass::outside},
                    FalsePromise{"depth_rounded_down",
                                 "room",
                                 {.depth_format = DepthFormat::unorm16},
                                 [](RasterPrecision& p) { p.depth_rounding = DepthRounding::truncate; },
                                 PixelClass::wrong_depth},
                    FalsePromise{"eight_depth_bits_more",
                                 "room",
                                 {.depth_format = DepthFormat::unorm16},
                                 [](RasterPrecision& p) { p.depth_format = DepthFormat::unorm24; },
                                 PixelClass::wrong_depth},
                    FalsePromise{"float_for_24_bits",
                                 "room",
                                 {.depth_format = DepthFormat::unorm24},
                                 [](RasterPrecision& p) { p.depth_format = DepthFormat::float32; },
                                 PixelClass::wrong_depth}),
    [](const auto& lie) { return lie.param.name; });

class VulkanAsOracle : public testing::TestWithParam<std::string> {};

TEST_P(VulkanAsOracle, AgreesWithTheCorrectRasterizerAndFailsABrokenOne) {
    const Loaded loaded = generate_suite_scene(GetParam(), width, height);
    const View& view = loaded.views.front();
    const oracle::VulkanDriver driver;
    const Frame oracle = driver.render(loaded.scene, view);
    const auto defects_of = [&](const Frame& frame) {
        return defect_count(
            judge(loaded.scene, view, {frame, rasterizer::precision()}, {oracle, driver.precision()}));
    };
    Frame frame = rasterizer::render(loaded.scene, view);
    EXPECT_EQ(defects_of(frame), 0u);
    frame.primitive.at(160, 120) = PrimitiveId::none;
    frame.camera_depth.at(160, 120) = background_depth;
    EXPECT_EQ(defects_of(frame), 1u);
}

INSTANTIATE_TEST_SUITE_P(Suite, VulkanAsOracle, testing::Values("room", "deep_overdraw", "far_from_origin"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
