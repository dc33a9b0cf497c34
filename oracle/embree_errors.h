/// The errors that an Embree device reports, turned into exceptions on our side of its C interface.
#pragma once

#include <mutex>
#include <string>

#include "oracle/rtcore.h"

namespace zproof::oracle {

/// Collects the errors of one device, from any thread. Stays where it is: the device holds its address.
class EmbreeErrors {
  public:
    EmbreeErrors() = default;
    EmbreeErrors(const EmbreeErrors&) = delete;
    EmbreeErrors& operator=(const EmbreeErrors&) = delete;

    /// Makes `device` report to this object.
    void attach_to(RTCDevice device);

    /// Throws OracleError with the first error since the last call, its code in words and Embree's own
    /// text, and what was being done: "Embree, while it built the scene 'room': out of memory: ...".
    void raise(const std::string& doing) const;

  private:
    static void note(void* self, RTCError code, const char* text);

    mutable std::mutex mutex_;
    mutable std::string first_;
};

/// Embree's error codes in words.
std::string in_words(RTCError code);

}  // namespace zproof::oracle
