// A library that is loaded into the program before all others, and makes its parts crash.
#include <dlfcn.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

#include "image_io/module_table.h"
#include "oracle/rtcore.h"

namespace {

using SetBuffer = void (*)(RTCGeometry, RTCBufferType, unsigned, RTCFormat, const void*, std::size_t,
                           std::size_t, std::size_t);

/// ACCIDENT is a signal's number, or "bad_alloc", "logic_error" or "exit".
void have_accident() {
    const char* const named = std::getenv("ACCIDENT");
    const std::string accident = named == nullptr ? "" : named;
    if (accident.empty()) return;
    if (accident == "bad_alloc") throw std::bad_alloc{};
    if (accident == "logic_error") throw std::logic_error{"an assumption does not hold"};
    if (accident == "exit") std::_Exit(9);
    const int number = std::stoi(accident);
    std::signal(number, SIG_DFL);
    std::raise(number);
}

zproof::image_io::OpenFile* open_none(const zproof::image_io::Source&) {
    have_accident();
    throw std::runtime_error{"no accident"};
}

void close_none(zproof::image_io::OpenFile*) {}

constexpr zproof::image_io::ModuleTable table{.open = open_none, .close = close_none};

}  // namespace

/// An image module (ZPROOF_IMAGE_IO) that reads nothing.
extern "C" const zproof::image_io::ModuleTable* zproof_image_io() { return &table; }

/// Embree's own (LD_PRELOAD), except for scenes of ACCIDENT_TRIANGLES triangles.
extern "C" void rtcSetSharedGeometryBuffer(RTCGeometry geometry, RTCBufferType type, unsigned slot,
                                           RTCFormat format, const void* values, std::size_t offset,
                                           std::size_t stride, std::size_t count) {
    const char* const unlucky = std::getenv("ACCIDENT_TRIANGLES");
    if (type == RTC_BUFFER_TYPE_INDEX && unlucky != nullptr && count == std::stoul(unlucky)) have_accident();
    reinterpret_cast<SetBuffer>(dlsym(RTLD_NEXT, "rtcSetSharedGeometryBuffer"))(
        geometry, type, slot, format, values, offset, stride, count);
}
