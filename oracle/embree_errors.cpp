#include "oracle/embree_errors.h"

#include <utility>

#include "oracle/oracle_error.h"

namespace zproof::oracle {

std::string in_words(RTCError code) {
    switch (code) {
        case RTC_ERROR_NONE:
            return "no error";
        case RTC_ERROR_UNKNOWN:
            return "unknown error";
        case RTC_ERROR_INVALID_ARGUMENT:
            return "invalid argument";
        case RTC_ERROR_INVALID_OPERATION:
            return "invalid operation";
        case RTC_ERROR_OUT_OF_MEMORY:
            return "out of memory";
        case RTC_ERROR_UNSUPPORTED_CPU:
            return "unsupported CPU";
        case RTC_ERROR_CANCELLED:
            return "cancelled";
        default:  // Embree 4 has others, for graphics cards
            return "error " + std::to_string(static_cast<int>(code));
    }
}

void EmbreeErrors::attach_to(RTCDevice device) { rtcSetDeviceErrorFunction(device, &note, this); }

void EmbreeErrors::note(void* self, RTCError code, const char* text) {
    auto* errors = static_cast<EmbreeErrors*>(self);
    const std::lock_guard lock(errors->mutex_);
    if (errors->first_.empty()) errors->first_ = in_words(code) + ": " + (text ? text : "no reason given");
}

void EmbreeErrors::raise(const std::string& doing) const {
    const std::lock_guard lock(mutex_);
    if (!first_.empty()) throw OracleError("Embree, while it " + doing + ": " + std::exchange(first_, {}));
}

}  // namespace zproof::oracle
