#include "oracle/block_rays.h"

#include <gtest/gtest.h>

#include <bit>

#include "scenes/suite.h"

namespace zproof::oracle {
namespace {

/// Zeros by their sign as well.
void expect_bits(const glm::vec3& expected, const float* x, const float* y, const float* z, int lane) {
    for (const auto& [e, given] : {std::pair{expected.x, x}, {expected.y, y}, {expected.z, z}})
        ASSERT_EQ(std::bit_cast<std::uint32_t>(given[lane]), std::bit_cast<std::uint32_t>(e)) << lane;
}

void expect_rays_of(const View& view) {
    const BlockRays rays(view);
    RTCRay16 block;
    rays.begin(block);
    for (int top = 0; top < view.height; top += 4)
        for (int left = 0; left < view.width; left += 4) {
            rays.aim(left, top, block);
            for (int lane = 0; lane < BlockRays::lanes; ++lane) {
                const PrimaryRay one = primary_ray(view, left + lane % 4, top + lane / 4);
                expect_bits(one.origin, block.org_x, block.org_y, block.org_z, lane);
                expect_bits(one.direction, block.dir_x, block.dir_y, block.dir_z, lane);
                ASSERT_EQ(block.tnear[lane], one.t_near);
                ASSERT_EQ(block.tfar[lane], one.t_far);
                block.tfar[lane] = 0;  // what Embree hit is not taken for the next block's end
                ASSERT_EQ(rays.origin_depth(), one.origin_depth);
            }
        }
}

/// Cameras of every kind are in the suite.
TEST(BlockRays, AreTheRaysOfTheirPixelsBitByBit) {
    for (const SuiteEntry& entry : suite_manifest())
        for (const View& view : generate_suite_scene(entry.name, 37, 22).views) {
            SCOPED_TRACE(entry.name + " " + view.name);
            expect_rays_of(view);
        }
}

/// Products of an axis' zeros are zeros of either sign.
TEST(BlockRays, KeepTheSignOfZero) {
    View view{.name = "axes", .camera = {}, .width = 4, .height = 2};
    view.camera.window = {.left = -2, .right = 2, .bottom = -1, .top = 1};
    for (const double z : {-1.0, 1.0}) {
        view.camera.right = {0, 0, z};
        view.camera.up = {0, -1, -0.0};
        view.camera.back = {-1, 0, 0};
        for (const Projection projection : {Projection::perspective, Projection::parallel}) {
            view.camera.projection = projection;
            expect_rays_of(view);
        }
    }
}

}  // namespace
}  // namespace zproof::oracle
