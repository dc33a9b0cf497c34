#include "oracle/rtcore.h"

#include <gtest/gtest.h>

#include "oracle/block_rays.h"
#include "oracle/embree_geometry.h"
#include "pictures.h"

namespace zproof::oracle {
namespace {

constexpr int lanes = BlockRays::lanes;

float depth_of(int lane) { return float(2 + lane); }

/// A triangle of its own in front of each pixel of 4 x 4.
Scene one_for_each_lane() {
    Scene scene;
    for (int lane = 0; lane < lanes; ++lane) {
        const glm::vec3 centre{float(lane % 4) - 1.5f, 1.5f - float(lane / 4), -1};
        for (const glm::vec3& aside : {glm::vec3{-0.4f, -0.3f, 0}, {0.4f, -0.3f, 0}, {0, 0.4f, 0}})
            scene.vertices.position_world.push_back(depth_of(lane) * (centre + aside));
        scene.triangles.emplace_back(3 * lane, 3 * lane + 1, 3 * lane + 2);
    }
    return scene;
}

struct Packet {
    alignas(64) std::array<int, lanes> valid;
    alignas(64) RTCRayHit16 rays;

    /// Every so manieth lane is to be traced.
    explicit Packet(int every) : rays{} {
        for (int lane = 0; lane < lanes; ++lane) valid[std::size_t(lane)] = lane % every == 0 ? -1 : 0;
        const BlockRays of_view(unit_pixels(4, 4));
        of_view.begin(rays.ray);
        of_view.aim(0, 0, rays.ray);
        std::fill_n(rays.hit.geomID, lanes, RTC_INVALID_GEOMETRY_ID);
    }
};

/// Processors trace 4, 8 or 16 rays side by side; narrower ones are within wider ones.
TEST(CoherentRays, EachLaneHasItsOwnHitWithEveryInstructionSet) {
    const Scene scene = one_for_each_lane();
    for (const char* const narrowed : {"max_isa=sse42", "max_isa=avx", "max_isa=avx2", ""})
        for (const int every : {1, 3, 5}) {
            SCOPED_TRACE(std::string{narrowed} + ", every " + std::to_string(every));
            const DeviceHandle device(rtcNewDevice(narrowed));
            const SceneHandle built = share_triangles(device.get(), scene);
            rtcCommitScene(built.get());
            Packet packet(every);
            CoherentRays(device.get(), built.get()).intersect(packet.valid.data(), packet.rays);
            for (int lane = 0; lane < lanes; lane += every) {
                EXPECT_EQ(packet.rays.hit.primID[lane], unsigned(lane));
                EXPECT_FLOAT_EQ(packet.rays.ray.tfar[lane], depth_of(lane));
            }
        }
}

}  // namespace
}  // namespace zproof::oracle
