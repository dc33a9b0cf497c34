#include "oracle/embree_geometry.h"

#include <malloc.h>

#include <string>

#include "oracle/embree_errors.h"
#include "oracle/oracle_error.h"
#include "scenes/judged_ranges.h"

namespace zproof::oracle {
namespace {

static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::uvec3) == 12, "shared as packed floats and indices");
static_assert(Positions::allocator_type::padding >= 4, "Embree loads 16 bytes at the last vertex");

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
    if (const std::string outside = outside_judged_ranges(scene); !outside.empty())
        throw OracleError("Embree: " + outside);
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
