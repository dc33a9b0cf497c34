/// Needs a device: libvulkan1, mesa-vulkan-drivers and vulkan-validationlayers. Where there is none, or
/// Vulkan is not built in, every test fails.
#include "oracle/vulkan.h"

#include <gmock/gmock.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <thread>

#include "oracle/oracle_error.h"
#include "pictures.h"
#include "scenes/standard_samples.h"
#include "scenes_at_random.h"
#include "validated_vulkan.h"

namespace zproof::oracle {
namespace {

using testing::HasSubstr;

using VulkanTest = ValidatedVulkan;

Frame drawn(const Corners& corners, const View& view, const VulkanSettings& settings = {}) {
    return Vulkan(scene_of(corners), VulkanDriver(settings)).render(view);
}

std::string refusal(const auto& asked) {
    try {
        asked();
    } catch (const OracleError& error) {
        return error.what();
    }
    return "accepted";
}

TEST_F(VulkanTest, IsThere) { EXPECT_EQ(vulkan_is_missing(), std::nullopt); }

TEST_F(VulkanTest, RowsRunDownAndColumnsRunRight) {
    const Corners upper_left{{-2.9f, 1.9f, -1}, {0, 1.9f, -1}, {-2.9f, -0.9f, -1}};
    EXPECT_EQ(picture(drawn(upper_left, unit_pixels(6, 4))), R"(
000...
00....
0.....
......
)");
}

/// The settings that change how z is made and stored, with what a depth of 4 between 1 and 1000 may err by.
struct DepthCase {
    VulkanSettings settings;
    float error;
};

std::vector<DepthCase> depth_cases() {
    std::vector<DepthCase> cases;
    for (const DepthFormat format : {DepthFormat::float32, DepthFormat::unorm24, DepthFormat::unorm16})
        for (const DepthBuffer buffer : {DepthBuffer::reversed_z, DepthBuffer::standard_z})
            for (const PlanesBy planes : {PlanesBy::z, PlanesBy::distances})
                cases.push_back({{.depth_format = format, .depth_buffer = buffer, .planes = planes},
                                 format == DepthFormat::unorm16 ? 16.1f / 0xFFFF : 2e-6f});
    return cases;
}

TEST_F(VulkanTest, DepthIsMeasuredAlongTheViewAxisWhateverHoldsIt) {
    View view = unit_pixels(6, 4);
    view.camera.near_depth = 1;
    for (const double far : {1000.0, std::numeric_limits<double>::infinity()})
        for (const auto& [settings, error] : depth_cases()) {
            view.camera.far_depth = far;
            const Frame frame = drawn(wall(4), view, settings);
            for (const float depth : frame.camera_depth.pixels()) EXPECT_NEAR(depth, 4, error);
        }
}

TEST_F(VulkanTest, NearestTriangleWinsWithinNearAndFar) {
    const Corners walls = together({wall(5), wall(3), wall(1)});
    View view = unit_pixels(1, 1);
    for (const auto& [settings, error] : depth_cases()) {
        const VulkanDriver driver(settings);
        const auto nearest = [&](double near, double far) {
            view.camera.near_depth = near;
            view.camera.far_depth = far;
            return driver.render(scene_of(walls), view);
        };
        constexpr double inf = std::numeric_limits<double>::infinity();
        EXPECT_EQ(nearest(0.1, 1000).primitive.at(0, 0), PrimitiveId{2});
        EXPECT_EQ(nearest(2, 4).primitive.at(0, 0), PrimitiveId{1});
        EXPECT_EQ(nearest(4, inf).primitive.at(0, 0), PrimitiveId{0});
        EXPECT_EQ(nearest(1.5, 2.5).primitive.at(0, 0), PrimitiveId::none);
        EXPECT_EQ(nearest(1.5, 2.5).camera_depth.at(0, 0), background_depth) << "not the far plane";
    }
}

TEST_F(VulkanTest, ParallelCameraSeesBehindItsEyeAndClipsAtFar) {
    View view = unit_pixels(1, 1);
    view.camera.projection = Projection::parallel;
    view.camera.near_depth = -4;
    view.camera.far_depth = 4;
    const Corners behind{{-9, -9, 3}, {9, -9, 3}, {0, 9, 3}};
    for (const auto& [settings, error] : depth_cases()) {
        const Frame frame = drawn(together({wall(2), behind}), view, settings);
        EXPECT_EQ(frame.primitive.at(0, 0), PrimitiveId{1});
        EXPECT_NEAR(frame.camera_depth.at(0, 0), -3, error);
        EXPECT_EQ(drawn(wall(5), view, settings).primitive.at(0, 0), PrimitiveId::none);
    }
}

TEST_F(VulkanTest, BothSidesAreSeenAndOfEqualDepthsTheFirstStays) {
    const Corners front = wall(2), back{front[0], front[2], front[1]};
    for (const DepthBuffer buffer : {DepthBuffer::reversed_z, DepthBuffer::standard_z}) {
        const VulkanSettings settings{.depth_buffer = buffer};
        EXPECT_EQ(drawn(front, unit_pixels(1, 1), settings).primitive.at(0, 0), PrimitiveId{0});
        EXPECT_EQ(drawn(back, unit_pixels(1, 1), settings).primitive.at(0, 0), PrimitiveId{0});
        EXPECT_EQ(drawn(together({front, front}), unit_pixels(1, 1), settings).primitive.at(0, 0),
                  PrimitiveId{0});
    }
}

TEST_F(VulkanTest, SceneWithoutTrianglesIsBackground) {
    for (const DepthBuffer buffer : {DepthBuffer::reversed_z, DepthBuffer::standard_z})
        EXPECT_TRUE(same_bits(drawn({}, unit_pixels(7, 5), {.depth_buffer = buffer}), Frame({7, 5})));
}

/// More than one draw call's worth of the device's own batches, most of them hidden.
Scene crowd() {
    Rng rng(7);
    return random_soup(rng, Camera{}, 20'000);
}

View crowd_view(const std::string& name) {
    View view{.name = name, .camera = {}, .width = 301, .height = 203};
    view.camera.near_depth = 2;
    return view;
}

TEST_F(VulkanTest, EveryRunEveryDeviceAndEverySourceOfIdsGivesTheSameBits) {
    const Scene scene = crowd();
    const Vulkan first(scene), second(scene);
    const Frame once = first.render(crowd_view("ties"));
    first.render(unit_pixels(8, 2));
    EXPECT_TRUE(same_bits(once, first.render(crowd_view("ties"))));
    EXPECT_TRUE(same_bits(once, second.render(crowd_view("ties"))));
    for (const IdSource ids : {IdSource::primitive, IdSource::vertex})
        EXPECT_TRUE(same_bits(once, VulkanDriver({.ids = ids}).render(scene, crowd_view("ties"))));
}

TEST_F(VulkanTest, AnyThreadMayAskAndAllAtOnce) {
    const Scene scene = crowd();
    const VulkanDriver driver;
    const Vulkan shared(scene, driver);
    const Frame alone = shared.render(crowd_view("alone"));
    std::vector<Frame> frames(8);
    {
        std::vector<std::jthread> threads;
        for (Frame& frame : frames)
            threads.emplace_back([&] { frame = Vulkan(scene, driver).render(crowd_view("thread")); });
    }
    for (const Frame& frame : frames) EXPECT_TRUE(same_bits(alone, frame));
    tbb::parallel_for(std::size_t(0), frames.size(),
                      [&](std::size_t i) { frames[i] = shared.render(crowd_view("task")); });
    for (const Frame& frame : frames) EXPECT_TRUE(same_bits(alone, frame));
}

/// An edge between the pattern's samples: two of four lie left of it.
TEST_F(VulkanTest, EachSampleIsItsOwnPicture) {
    const Corners left{{-9, -9, -1}, {0, -9, -1}, {0, 9, -1}, {-9, -9, -1}, {0, 9, -1}, {-9, 9, -1}};
    View view = unit_pixels(1, 1);
    for (const DepthFormat format : {DepthFormat::float32, DepthFormat::unorm16})
        for (const Sample& sample : standard_samples(4)) {
            view.sample = sample;
            const Frame frame = drawn(left, view, {.depth_format = format});
            EXPECT_EQ(frame.primitive.at(0, 0) != PrimitiveId::none, sample.offset_px.x < 0);
            if (sample.offset_px.x < 0) {
                EXPECT_NEAR(frame.camera_depth.at(0, 0), 1, 3e-4);
            }
        }
}

TEST_F(VulkanTest, ASampleElsewhereIsRefused) {
    View view = unit_pixels(1, 1);
    view.sample.offset_px = {0.25, 0};
    EXPECT_THAT(refusal([&] { drawn(wall(1), view); }), HasSubstr("standard places only"));
    view.sample = standard_samples(16)[3];
    EXPECT_THAT(refusal([&] { drawn(wall(1), view); }), HasSubstr("no 16 samples"));
    view.sample = standard_samples(4)[3];
    EXPECT_THAT(refusal([&] { drawn(wall(1), view, {.depth_format = DepthFormat::unorm24}); }),
                HasSubstr("24 bits"));
    EXPECT_THAT(refusal([&] { drawn(wall(1), view, {.attributes = Values::all}); }),
                HasSubstr("attributes are read from one sample only"));
}

/// Weights of corners, and what a scene without uv and normals has beside them.
TEST_F(VulkanTest, AttributesAreThoseOfTheTriangleThatIsSeen) {
    const Scene scene = scene_of(together({wall(3), wall(2)}));
    const VulkanDriver driver({.attributes = Values::all});
    const Frame frame = Vulkan(scene, driver).render(unit_pixels(3, 2));
    EXPECT_TRUE(frame.attributes.has(Attribute::barycentrics) && frame.attributes.has(Attribute::position));
    EXPECT_FALSE(frame.attributes.has(Attribute::uv) || frame.attributes.has(Attribute::normal));
    EXPECT_EQ(frame.primitive.at(2, 1), PrimitiveId{1});
    const auto at = [&](std::size_t channel) { return frame.attributes.planes[channel].at(2, 1); };
    const auto corner = [&](std::uint32_t i) {
        return scene.vertices.position_world[scene.triangles[1][int(i)]];
    };
    const glm::vec3 p = (1 - at(0) - at(1)) * corner(0) + at(0) * corner(1) + at(1) * corner(2);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(at(7 + axis), p[int(axis)], 1e-4);
    EXPECT_THAT(refusal([] { VulkanDriver({.ids = IdSource::primitive, .attributes = Values::all}); }),
                HasSubstr("ids of vertices"));
}

TEST_F(VulkanTest, AnImageLargerThanTheDeviceAllowsIsRefusedBySize) {
    EXPECT_THAT(refusal([] { drawn(wall(1), unit_pixels(1'000'000, 1)); }), HasSubstr("1000000 x 1"));
}

TEST_F(VulkanTest, ADeviceIsChosenByPartOfItsName) {
    EXPECT_THAT(VulkanDriver({.device = "llvmpipe"}).version(), HasSubstr("llvmpipe"));
    EXPECT_THAT(refusal([] { VulkanDriver({.device = "Voodoo"}); }),
                testing::AllOf(HasSubstr("'Voodoo'"), HasSubstr("llvmpipe")));
    EXPECT_THAT(vulkan_is_missing({.device = "Voodoo"}), testing::Optional(HasSubstr("llvmpipe")));
}

TEST_F(VulkanTest, ADepthThatNoBufferHoldsIsRefused) {
    EXPECT_THAT(refusal([] { VulkanDriver({.depth_format = DepthFormat::float64}); }), HasSubstr("format"));
}

TEST_F(VulkanTest, NamesDeviceDriverAndVersion) {
    EXPECT_THAT(VulkanDriver().version(), testing::MatchesRegex(".+, .+, Vulkan 1\\.[0-9]+\\.[0-9]+"));
}

/// What is promised are the device's limits; Vulkan asks for 4 sub-pixel bits at least (1.3, table 57).
TEST_F(VulkanTest, PromisesTheDevicesLimits) {
    const VulkanDevice device = vulkan_devices().front();
    EXPECT_GE(device.subpixel_bits, 4);
    EXPECT_GE(device.largest_side_px, 4096);
    EXPECT_THAT(device.sample_counts, testing::Contains(1));
    EXPECT_THAT(device.depth_formats, testing::Contains(DepthFormat::unorm16));
    const auto precision = std::get<RasterPrecision>(
        VulkanDriver({.depth_format = DepthFormat::unorm16, .depth_buffer = DepthBuffer::standard_z})
            .precision());
    EXPECT_EQ(precision.subpixel_bits, device.subpixel_bits);
    EXPECT_EQ(precision.depth_buffer, DepthBuffer::standard_z);
    EXPECT_EQ(precision.depth_format, DepthFormat::unorm16);
    EXPECT_EQ(precision.depth_rounding, DepthRounding::either);
    EXPECT_EQ(precision.matrix_far, MatrixFar::finite);
}

}  // namespace
}  // namespace zproof::oracle
