/// Embree's handles, owned; and the baked scene as Embree sees it.
#pragma once

#include <memory>
#include <type_traits>

#include "oracle/rtcore.h"
#include "scenes/scene.h"

namespace zproof::oracle {

struct ReleaseEmbree {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};

using DeviceHandle = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseEmbree>;
using SceneHandle = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseEmbree>;
using GeometryHandle = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseEmbree>;

/// A scene of so many triangles gets Embree's compact tree: leaves hold the triangles' indices, not their
/// corners, and the tree is built in the memory of the boxes that it is built from. It takes 35 to 40 bytes a
/// triangle at most instead of 95, is built faster, and gives the same hits; where rays try many triangles
/// each (slivers, a soup) they take 1.2 to 1.9 times as long (docs/performance.md), so smaller scenes do
/// without.
inline constexpr std::size_t compact_from_triangles = 500'000;

/// A device with Embree's defaults. Throws OracleError with Embree's reason.
DeviceHandle new_device();

/// The scene's triangles as one robust Embree scene, triangle i = primitive i, not built yet. The vertices
/// and indices are shared, not copied. Throws OracleError, naming vertex and scene, where a coordinate is not
/// judged (scenes/judged_ranges.h): Embree drops triangles from 1.844e18 on, and its products overflow
/// before.
SceneHandle share_triangles(RTCDevice device, const Scene& scene);

}  // namespace zproof::oracle
