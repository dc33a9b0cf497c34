#include "oracle/rtcore.h"

#include <cstring>

namespace zproof::oracle {
namespace {

int native_lanes_of(RTCDevice device) {
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) return 16;
    return rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0 ? 8 : 4;
}

#if ZPROOF_EMBREE == 3

/// Embree 3 itself parts what is wider than the processor.
void trace(RTCScene scene, int, const int* valid, RTCRayHit16& packet) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, scene, &context, &packet);
}

#else

template <class Part>
using Intersect = void (*)(const int*, RTCScene, Part*, RTCIntersectArguments*);

/// Parts are of so many lanes, one after another.
template <class Part, std::size_t lanes>
void trace_in_parts(Intersect<Part> intersect, RTCScene scene, const int* valid, RTCRayHit16& packet,
                    RTCIntersectArguments arguments) {
    // Both are arrays of values of 4 bytes, each value for all lanes.
    constexpr std::size_t bytes = 4 * lanes, bytes_of_packet = 4 * 16, values = sizeof(Part) / bytes;
    static_assert(sizeof(Part) == values * bytes && sizeof packet == values * bytes_of_packet);
    for (std::size_t first = 0; first < 16; first += lanes) {
        alignas(64) unsigned char part[sizeof(Part)];
        unsigned char* const lane = reinterpret_cast<unsigned char*>(&packet) + 4 * first;
        for (std::size_t i = 0; i < values; ++i)
            std::memcpy(part + i * bytes, lane + i * bytes_of_packet, bytes);
        intersect(valid + first, scene, reinterpret_cast<Part*>(part), &arguments);
        for (std::size_t i = 0; i < values; ++i)
            std::memcpy(lane + i * bytes_of_packet, part + i * bytes, bytes);
    }
}

/// Embree 4 would trace what is wider than the processor ray by ray: that takes thrice the time, and among
/// exactly equal depths other triangles are hit than by Embree 3.
void trace(RTCScene scene, int native_lanes, const int* valid, RTCRayHit16& packet) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    if (native_lanes == 16)
        rtcIntersect16(valid, scene, &packet, &arguments);
    else if (native_lanes == 8)
        trace_in_parts<RTCRayHit8, 8>(rtcIntersect8, scene, valid, packet, arguments);
    else
        trace_in_parts<RTCRayHit4, 4>(rtcIntersect4, scene, valid, packet, arguments);
}

#endif

}  // namespace

CoherentRays::CoherentRays(RTCDevice device, RTCScene scene)
    : scene_(scene), native_lanes_(native_lanes_of(device)) {}

void CoherentRays::intersect(const int* valid, RTCRayHit16& packet) const {
    trace(scene_, native_lanes_, valid, packet);
}

}  // namespace zproof::oracle
