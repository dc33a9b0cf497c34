#include "oracle/embree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>

#include "oracle/block_rays.h"
#include "oracle/embree_errors.h"
#include "oracle/embree_geometry.h"
#include "oracle/oracle_error.h"
#include "oracle/primary_ray.h"
#include "scenes/judged_ranges.h"

namespace zproof::oracle {
namespace {

/// A packet is a block of 4 x 4 pixels, so that its rays stay together; lane = 4 row + column. The blocks
/// stand at multiples of 4 whatever the threads do: Embree's choice among exactly equal depths depends on a
/// packet's company.
constexpr int block_side = BlockRays::side;
constexpr int lane_count = BlockRays::lanes;
constexpr int blocks_per_tile_side = 8, tile_side_px = blocks_per_tile_side * block_side;

/// The upper left pixel of a block.
struct Block {
    int x, y;
};

struct Packet {
    alignas(64) std::array<int, lane_count> valid;  ///< -1 = trace this lane, 0 = leave it
    alignas(64) RTCRayHit16 rays;

    Packet() {
        std::fill_n(rays.hit.instID[0], lane_count, RTC_INVALID_GEOMETRY_ID);
        begin();
    }
    /// Asks for all lanes, and forgets what was hit.
    void begin() {
        valid.fill(-1);
        std::fill_n(rays.hit.geomID, lane_count, RTC_INVALID_GEOMETRY_ID);
    }
    bool is_hit(int lane) const { return rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID; }
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
}

/// What of the block lies in the image.
struct BlockPart {
    int columns, rows;

    bool is_whole() const { return columns == block_side && rows == block_side; }
};

BlockPart part_in(const Resolution& size, const Block& block) {
    return {std::min(block_side, size.width - block.x), std::min(block_side, size.height - block.y)};
}

void leave_out_what_is_beyond(Packet& packet, const BlockPart& part) {
    for (int lane = 0; lane < lane_count; ++lane)
        if (lane % block_side >= part.columns || lane / block_side >= part.rows)
            packet.valid[std::size_t(lane)] = 0;
}

/// What a packet found, lane by lane.
struct ClosestHits {
    alignas(64) std::array<PrimitiveId, lane_count> primitive;
    alignas(64) std::array<float, lane_count> camera_depth;
};

/// Nearly all views begin at the eye: nothing is added there but to the sign of zero.
float camera_depth_at(float t, double origin_depth) {
    return origin_depth == 0 ? t + 0.0f : float(origin_depth + double{t});
}

ClosestHits hits_of(const Packet& packet, double origin_depth) {
    ClosestHits hits;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const bool is_hit = packet.is_hit(int(lane));
        const float depth = camera_depth_at(packet.rays.ray.tfar[lane], origin_depth);
        hits.primitive[lane] = is_hit ? PrimitiveId{packet.rays.hit.primID[lane]} : PrimitiveId::none;
        hits.camera_depth[lane] = is_hit ? depth : background_depth;
    }
    return hits;
}

/// A whole block's row has a number of values that the compiler knows.
template <class T>
void store_row(const T* values, int columns, T* to) {
    if (columns == block_side)
        std::copy_n(values, block_side, to);
    else
        std::copy_n(values, columns, to);
}

void store(const ClosestHits& hits, const Block& block, const BlockPart& part, Frame& frame) {
    for (int row = 0; row < part.rows; ++row) {
        const auto first = std::size_t(row * block_side);
        store_row(&hits.primitive[first], part.columns, &frame.primitive.at(block.x, block.y + row));
        store_row(&hits.camera_depth[first], part.columns, &frame.camera_depth.at(block.x, block.y + row));
    }
}

/// Embree's u and v, where the frame has planes for them.
void store_barycentrics(const Packet& packet, const Block& block, const BlockPart& part, Frame& frame) {
    for (int row = 0; row < part.rows; ++row) {
        const int first = row * block_side;
        store_row(packet.rays.hit.u + first, part.columns,
                  &frame.attributes.planes[0].at(block.x, block.y + row));
        store_row(packet.rays.hit.v + first, part.columns,
                  &frame.attributes.planes[1].at(block.x, block.y + row));
    }
}

/// packet: begun for the view, and left as the block before had it.
void trace_block(const CoherentRays& scene, const BlockRays& rays, const Block& block, Packet& packet,
                 Frame& frame) {
    const BlockPart part = part_in(frame.size(), block);
    packet.begin();
    if (!part.is_whole()) leave_out_what_is_beyond(packet, part);
    rays.aim(block.x, block.y, packet.rays.ray);
    scene.intersect(packet.valid.data(), packet.rays);
    store(hits_of(packet, rays.origin_depth()), block, part, frame);
    if (frame.attributes.has(Attribute::barycentrics)) store_barycentrics(packet, block, part, frame);
}

/// Every second bit of a Morton code, from the lowest.
constexpr int every_second_bit(unsigned code) {
    int bits = 0;
    for (int i = 0; i < 16; ++i) bits |= int(code >> 2 * i & 1) << i;
    return bits;
}

/// The places of a tile's blocks in it, each near the one before it.
constexpr auto blocks_of_tile = [] {
    std::array<Block, blocks_per_tile_side * blocks_per_tile_side> blocks{};
    for (unsigned code = 0; code < blocks.size(); ++code)
        blocks[code] = {every_second_bit(code) * block_side, every_second_bit(code >> 1) * block_side};
    return blocks;
}();

void trace_tile(const CoherentRays& scene, const BlockRays& rays, const Block& tile, Frame& frame) {
    Packet packet;
    rays.begin(packet.rays.ray);
    for (const Block& in_tile : blocks_of_tile) {
        const Block block{tile.x + in_tile.x, tile.y + in_tile.y};
        if (block.x < frame.size().width && block.y < frame.size().height)
            trace_block(scene, rays, block, packet, frame);
    }
}

/// Embree says how many rays it traces at once, not what with.
std::string instruction_set_of(RTCDevice device) {
    const bool eight = rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED);
#ifdef __x86_64__
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return "AVX-512";
    if (eight) return __builtin_cpu_supports("avx2") ? "AVX2" : "AVX";
    return "SSE";
#else
    return eight ? "NEON2X" : "NEON";
#endif
}

}  // namespace

struct Embree::Device {
    explicit Device(const Scene& scene) : device(new_device()) {
        errors.attach_to(device.get());
        triangles = share_triangles(device.get(), scene);
        errors.raise("took over the scene '" + scene.name + "'");
        // For TBB it is rtcCommitScene that builds in the surrounding arena; rtcJoinCommitScene would use
        // Embree's own.
        rtcCommitScene(triangles.get());
        errors.raise("built the scene '" + scene.name + "'");
    }

    CoherentRays rays() const { return {device.get(), triangles.get()}; }

    EmbreeErrors errors;  ///< outlives the device, which reports to it
    DeviceHandle device;
    SceneHandle triangles;
};

Embree::Embree(const Scene& scene) : device_(std::make_unique<Device>(scene)) {}
Embree::~Embree() = default;
Embree::Embree(Embree&&) noexcept = default;
Embree& Embree::operator=(Embree&&) noexcept = default;

Frame Embree::trace(const View& view) const {
    if (const std::string outside = outside_judged_ranges(view); !outside.empty())
        throw OracleError("Embree: " + outside);
    Frame frame = Frame::unwritten({view.width, view.height});
    trace_into(frame, view);
    return frame;
}

Frame Embree::trace_with_barycentrics(const View& view) const {
    Frame frame = Frame::unwritten({view.width, view.height});
    frame.attributes.planes[0] = frame.attributes.planes[1] = Plane<float>(frame.size());
    trace_into(frame, view);
    return frame;
}

void Embree::trace_into(Frame& frame, const View& view) const {
    const BlockRays rays(view);
    const CoherentRays scene = device_->rays();
    const unsigned tiles_a_side =
        std::bit_ceil(unsigned(std::max(view.width, view.height) - 1) / tile_side_px + 1);
    tbb::parallel_for(0u, tiles_a_side * tiles_a_side, [&](unsigned code) {
        const Block tile{every_second_bit(code) * tile_side_px, every_second_bit(code >> 1) * tile_side_px};
        if (tile.x < view.width && tile.y < view.height) trace_tile(scene, rays, tile, frame);
    });
    device_->errors.raise("traced the view '" + view.name + "'");
}

std::vector<PrimitiveId> Embree::met(const View& view, std::span<const glm::dvec2> p_raster) const {
    std::vector<PrimitiveId> hits(p_raster.size(), PrimitiveId::none);
    const CoherentRays scene = device_->rays();
    for (std::size_t first = 0; first < p_raster.size(); first += lane_count) {
        Packet packet;
        for (int lane = 0; lane < lane_count; ++lane) {
            const std::size_t at = std::min(first + std::size_t(lane), p_raster.size() - 1);
            set_lane(packet, lane, ray_through(view, p_raster[at]));
        }
        scene.intersect(packet.valid.data(), packet.rays);
        for (std::size_t lane = 0; lane < lane_count && first + lane < p_raster.size(); ++lane)
            if (packet.is_hit(int(lane))) hits[first + lane] = PrimitiveId{packet.rays.hit.primID[lane]};
    }
    return hits;
}

Precision embree_precision() { return RayPrecision{Arithmetic::float32}; }

std::string embree_version() {
    const DeviceHandle device = new_device();
    const auto property = [&](RTCDeviceProperty which) { return rtcGetDeviceProperty(device.get(), which); };
    const std::string version = std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_MAJOR)) + "." +
                                std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_MINOR)) + "." +
                                std::to_string(property(RTC_DEVICE_PROPERTY_VERSION_PATCH));
    return "Embree " + version + " (" + instruction_set_of(device.get()) + ")";
}

}  // namespace zproof::oracle
