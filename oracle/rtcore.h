/// Embree 3 or 4, the one that the build found (ZPROOF_EMBREE): all that differs between them is here.
#pragma once

#if ZPROOF_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

namespace zproof::oracle {

/// A built scene that is asked with 16 coherent rays at a time. Outlived by device and scene.
class CoherentRays {
  public:
    CoherentRays(RTCDevice device, RTCScene scene);

    /// Finds the closest hits. valid: -1 for a lane to trace, else 0; aligned to 64 bytes.
    void intersect(const int* valid, RTCRayHit16& packet) const;

  private:
    RTCScene scene_;
    int native_lanes_;  ///< that the processor traces side by side: 4, 8 or 16
};

}  // namespace zproof::oracle
