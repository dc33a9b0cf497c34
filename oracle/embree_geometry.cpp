#include "oracle/embree_geometry.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "oracle/embree_errors.h"
#include "oracle/oracle_error.h"

namespace zproof::oracle {
namespace {

static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::uvec3) == 12, "shared as packed floats and indices");
static_assert(Positions::allocator_type::padding >= 4, "Embree loads 16 bytes at the last vertex");

bool acceptable(const glm::vec3& p) {
    const auto small = [](float c) { return std::abs(c) < embree_coordinate_limit; };  // false for NaN
    return small(p.x) && small(p.y) && small(p.z);
}

void refuse_unacceptable_positions(const Scene& scene) {
    const Positions& positions = scene.vertices.position_world;
    const auto bad = std::ranges::find_if_not(positions, acceptable);
    if (bad == positions.end()) return;
    throw OracleError(
        "Embree: vertex " + std::to_string(bad - positions.begin()) + " of scene '" + scene.name +
        "' is NaN or beyond 1.844e18, and Embree would drop its triangles; scale the scene down");
}

GeometryHandle triangle_geometry(RTCDevice device, const Scene& scene) {
    GeometryHandle geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    const Positions& positions = scene.vertices.position_world;
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(),
                               0, sizeof(glm::vec3), positions.size());
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               scene.triangles.data(), 0, sizeof(glm::uvec3), scene.triangles.size());
    rtcCommitGeometry(geometry.get());
    return geometry;
}

RTCSceneFlags flags_for(std::size_t triangles) {
    return triangles < compact_from_triangles ? RTC_SCENE_FLAG_ROBUST
                                              : RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT;
}

}  // namespace

DeviceHandle new_device() {
    DeviceHandle device(rtcNewDevice(nullptr));
    if (!device)
        throw OracleError("Embree, while it opened a device: " + in_words(rtcGetDeviceError(nullptr)));
    return device;
}

SceneHandle share_triangles(RTCDevice device, const Scene& scene) {
    refuse_unacceptable_positions(scene);
    // A large tree takes memory of its own; what was freed before need not lie idle beside it.
    if (scene.triangles.size() >= compact_from_triangles) malloc_trim(0);
    SceneHandle shared(rtcNewScene(device));
    rtcSetSceneFlags(shared.get(), flags_for(scene.triangles.size()));
    if (!scene.triangles.empty()) {
        rtcAttachGeometry(shared.get(), triangle_geometry(device, scene).get());
    }
    return shared;
}

}  // namespace zproof::oracle
