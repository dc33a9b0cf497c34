/// Embree as the reference: one robust primary ray per pixel centre.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// A scene handed to Embree. Geometry is shared without a copy: the scene must outlive this object.
class Embree {
  public:
    /// Builds the acceleration structure. Throws OracleError with Embree's own words where the device
    /// refuses.
    explicit Embree(const Scene& scene);
    ~Embree();
    Embree(Embree&&) noexcept;
    Embree& operator=(Embree&&) noexcept;

    /// Traces the view on the threads of the surrounding tbb::task_arena. Ray directions have unit camera
    /// depth, so that the hit distance is the camera depth and tnear/tfar are the near and far planes. Throws
    /// OracleError for a view that is not judged (scenes/judged_ranges.h).
    Frame trace(const View& view) const;
    /// The frame with Embree's u and v as the attribute `bary`.
    Frame trace_with_barycentrics(const View& view) const;

    /// The triangle that the view ray through each of these raster positions meets, on the calling
    /// thread.
    std::vector<PrimitiveId> met(const View& view, std::span<const glm::dvec2> p_raster) const;

  private:
    void trace_into(Frame& frame, const View& view) const;

    struct Device;
    std::unique_ptr<Device> device_;
};

/// What Embree's float32 robust intersector can promise (docs/bounds.md).
Precision embree_precision();

/// "Embree 3.13.5" and the instruction set in use, for the report.
std::string embree_version();

}  // namespace zproof::oracle
