// The reference's frame beside nothing but Embree's own work for it: the same packets, made beforehand.
#include <tbb/parallel_for.h>

#include "bench/lazy.h"
#include "bench/scenes.h"
#include "bench/suites.h"
#include "oracle/embree.h"
#include "oracle/embree_geometry.h"
#include "oracle/primary_ray.h"

namespace zproof::bench {
namespace {

constexpr int packet_side = 4, lanes = packet_side * packet_side;

struct alignas(64) Packet {
    std::array<int, lanes> valid;
    RTCRayHit16 rays;
};

Packet packet_at(const View& view, int left, int top) {
    Packet packet;
    for (int lane = 0; lane < lanes; ++lane) {
        const oracle::PrimaryRay ray =
            oracle::primary_ray(view, left + lane % packet_side, top + lane / packet_side);
        packet.valid[std::size_t(lane)] = -1;
        RTCRay16& to = packet.rays.ray;
        to.org_x[lane] = ray.origin.x, to.org_y[lane] = ray.origin.y, to.org_z[lane] = ray.origin.z;
        to.dir_x[lane] = ray.direction.x, to.dir_y[lane] = ray.direction.y, to.dir_z[lane] = ray.direction.z;
        to.tnear[lane] = ray.t_near, to.tfar[lane] = ray.t_far;
        to.time[lane] = 0, to.mask[lane] = ~0u, to.id[lane] = unsigned(lane), to.flags[lane] = 0;
        packet.rays.hit.geomID[lane] = packet.rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    return packet;
}

/// The bare loop: packets are copied, since Embree writes its hits into them.
class BareEmbree {
  public:
    explicit BareEmbree(const TimedScene& timed)
        : device_(oracle::new_device()), scene_(oracle::share_triangles(device_.get(), timed.scene)) {
        rtcCommitScene(scene_.get());
        for (int y = 0; y < timed.view.height; y += packet_side)
            for (int x = 0; x < timed.view.width; x += packet_side)
                packets_.push_back(packet_at(timed.view, x, y));
    }
    void trace() const {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, packets_.size(), 64), [&](const auto& some) {
            const oracle::CoherentRays scene{device_.get(), scene_.get()};
            for (std::size_t i = some.begin(); i < some.end(); ++i) {
                Packet packet = packets_[i];
                scene.intersect(packet.valid.data(), packet.rays);
                benchmark::DoNotOptimize(packet);
            }
        });
    }

  private:
    oracle::DeviceHandle device_;
    oracle::SceneHandle scene_;
    std::vector<Packet> packets_;
};

void add_embree_scene(const std::string& name, TimedScene (*make)()) {
    const Lazy<TimedScene> timed{make};
    const Lazy<oracle::Embree> ours{[=] { return oracle::Embree{timed->scene}; }};
    const Lazy<BareEmbree> bare{[=] { return BareEmbree{*timed}; }};
    add("oracle/" + name + "/zproof", [=] { benchmark::DoNotOptimize(ours->trace(timed->view)); });
    add("oracle/" + name + "/bare Embree", [=] { bare->trace(); });
    add("oracle_build/" + name + "/zproof", [=] { benchmark::DoNotOptimize(oracle::Embree{timed->scene}); });
}

}  // namespace

void add_oracle() {
    add_embree_scene("room", room);
    add_embree_scene("ripples", [] { return ripples(); });
    add_embree_scene("soup", soup);
}

}  // namespace zproof::bench
