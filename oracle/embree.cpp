#include "oracle/embree.h"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "oracle/embree_complaints.h"
#include "oracle/embree_geometry.h"
#include "oracle/primary_ray.h"

namespace zproof::oracle {
namespace {

/// A packet is a block of 4 x 4 pixels, so that its rays stay together; lane = 4 row + column. The blocks
/// stand at multiples of 4 whatever the threads do: Embree's choice among exactly equal depths depends on a
/// packet's company.
constexpr int block_side = 4;
constexpr int lane_count = block_side * block_side;
constexpr int blocks_per_task_side = 8;

/// The upper left pixel of a block.
struct Block {
    int x, y;
};

struct Packet {
    alignas(64) std::array<int, lane_count> valid;  ///< -1 = trace this lane, 0 = pixel outside the image
    alignas(64) RTCRayHit16 rays;
    std::array<double, lane_count> origin_depth;
};

void set_lane(Packet& packet, int lane, const PrimaryRay& ray) {
    RTCRay16& to = packet.rays.ray;
    to.org_x[lane] = ray.origin.x;
    to.org_y[lane] = ray.origin.y;
    to.org_z[lane] = ray.origin.z;
    to.dir_x[lane] = ray.direction.x;
    to.dir_y[lane] = ray.direction.y;
    to.dir_z[lane] = ray.direction.z;
    to.tnear[lane] = ray.t_near;
    to.tfar[lane] = ray.t_far;
    to.time[lane] = 0;
    to.mask[lane] = ~0u;
    to.id[lane] = static_cast<unsigned>(lane);
    to.flags[lane] = 0;
    packet.rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    packet.origin_depth[static_cast<std::size_t>(lane)] = ray.origin_depth;
}

void aim(Packet& packet, const View& view, Block block) {
    for (int lane = 0; lane < lane_count; ++lane) {
        const int x = block.x + lane % block_side, y = block.y + lane / block_side;
        packet.valid[static_cast<std::size_t>(lane)] = x < view.width && y < view.height ? -1 : 0;
        set_lane(packet, lane, primary_ray(view, x, y));
    }
}

void store_hits(const Packet& packet, Block block, Frame& frame) {
    for (int lane = 0; lane < lane_count; ++lane) {
        const auto at = static_cast<std::size_t>(lane);
        if (packet.valid[at] == 0 || packet.rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
        const int x = block.x + lane % block_side, y = block.y + lane / block_side;
        const double depth = packet.origin_depth[at] + double{packet.rays.ray.tfar[lane]};
        frame.primitive.at(x, y) = PrimitiveId{packet.rays.hit.primID[lane]};
        frame.camera_depth.at(x, y) = static_cast<float>(depth);
    }
}

void intersect(RTCScene scene, Packet& packet) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(packet.valid.data(), scene, &context, &packet.rays);
}

void trace_block(RTCScene scene, const View& view, Block block, Frame& frame) {
    Packet packet;
    aim(packet, view, block);
    intersect(scene, packet);
    store_hits(packet, block, frame);
}

int blocks_across(int pixels) { return (pixels + block_side - 1) / block_side; }

}  // namespace

struct Embree::Device {
    explicit Device(const Scene& scene) : device(new_device()) {
        complaints.listen_to(device.get());
        triangles = share_triangles(device.get(), scene);
        complaints.raise("took over the scene '" + scene.name + "'");
        // For TBB it is rtcCommitScene that builds in the surrounding arena; rtcJoinCommitScene would use
        // Embree's own.
        rtcCommitScene(triangles.get());
        complaints.raise("built the scene '" + scene.name + "'");
    }

    EmbreeComplaints complaints;  ///< outlives the device, which reports to it
    DeviceHandle device;
    SceneHandle triangles;
};

Embree::Embree(const Scene& scene) : device_(std::make_unique<Device>(scene)) {}
Embree::~Embree() = default;
Embree::Embree(Embree&&) noexcept = default;
Embree& Embree::operator=(Embree&&) noexcept = default;

Frame Embree::trace(const View& view) const {
    Frame frame({view.width, view.height});
    const tbb::blocked_range2d<int> blocks(0, blocks_across(view.height), blocks_per_task_side, 0,
                                           blocks_across(view.width), blocks_per_task_side);
    tbb::parallel_for(blocks, [&](const tbb::blocked_range2d<int>& task) {
        for (int row = task.rows().begin(); row < task.rows().end(); ++row) {
            for (int column = task.cols().begin(); column < task.cols().end(); ++column) {
                trace_block(device_->triangles.get(), view, {column * block_side, row * block_side}, frame);
            }
        }
    });
    device_->complaints.raise("traced the view '" + view.name + "'");
    return frame;
}

std::vector<PrimitiveId> Embree::met(const View& view, std::span<const glm::dvec2> p_raster) const {
    std::vector<PrimitiveId> found(p_raster.size(), PrimitiveId::none);
    for (std::size_t first = 0; first < p_raster.size(); first += lane_count) {
        Packet packet;
        for (int lane = 0; lane < lane_count; ++lane) {
            const std::size_t at = std::min(first + std::size_t(lane), p_raster.size() - 1);
            packet.valid[std::size_t(lane)] = -1;
            set_lane(packet, lane, ray_through(view, p_raster[at]));
        }
        intersect(device_->triangles.get(), packet);
        for (std::size_t lane = 0; lane < lane_count && first + lane < p_raster.size(); ++lane)
            if (packet.rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID)
                found[first + lane] = PrimitiveId{packet.rays.hit.primID[lane]};
    }
    return found;
}

Precision embree_precision() { return RayPrecision{Arithmetic::float32}; }

std::string embree_version() {
    const DeviceHandle device = new_device();
    const auto property = [&](RTCDeviceProperty which) { return rtcGetDeviceProperty(device.get(), which); };
    const std::string version = std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_MAJOR)) + "." +
                                std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_MINOR)) + "." +
                                std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_PATCH));
    if (property(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return "Embree " + version + " (AVX-512)";
    if (property(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) {
        return "Embree " + version + (__builtin_cpu_supports("avx2") ? " (AVX2)" : " (AVX)");
    }
    return "Embree " + version + " (SSE)";
}

}  // namespace zproof::oracle
