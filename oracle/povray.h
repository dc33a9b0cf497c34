/// POV-Ray 3.7 as a reference: a ray tracer that shares no code with us and computes in double, run as a
/// program of its own.
///
/// Each triangle is written as a `triangle` of POV-Ray's, in double (its meshes hold float32), and each
/// pixel's colour says which one was met and how deep (povray/code.h). One ray per pixel centre; two-sided.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "frame/frame.h"
#include "frame/picture.h"
#include "frame/precision.h"
#include "oracle/povray/picture.h"
#include "scenes/light.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

struct PovRayOptions {
    std::string program = "povray";                                   ///< by path or as found on PATH
    std::chrono::milliseconds time_limit = std::chrono::minutes(10);  ///< for one view
};

/// A scene to be shown to POV-Ray, which must outlive this object. Every view is a run of the program, for it
/// keeps nothing from one picture to the next.
class PovRay {
  public:
    explicit PovRay(const Scene& scene, PovRayOptions options = {})
        : scene_(scene), options_(std::move(options)) {}

    /// Traces the view on as many threads as the surrounding tbb::task_arena has. Throws OracleError where
    /// the program is missing, fails (with the end of what it said), runs out of time, or where the view is
    /// beyond its means: depths of more than 1e9 from nearest to farthest, or more than 2^20 triangles.
    Frame render(const View& view) const;

    /// Starts POV-Ray on the view; the result, to be called once, waits for the frame. Its time runs
    /// meanwhile. Where the result is dropped, POV-Ray is killed. Throws OracleError as render, here or when
    /// it is called.
    std::function<Frame()> begin(const View& view, int threads) const;

    /// A lit, textured picture of the same view (oracle/povray/picture.h), linear, 16 bits a channel, cut to
    /// [0, 1]. Throws OracleError as render, and for what povray_picture refuses.
    Picture picture(const View& view, const Light& light, const PhongFinish& phong_finish = {}) const;

  private:
    const Scene& scene_;
    PovRayOptions options_;
};

/// What POV-Ray promises by its design (docs/bounds.md).
Precision povray_precision();

/// "POV-Ray 3.7.0.10", for the report; nothing where the program is not installed.
std::optional<std::string> povray_version(const std::string& program = "povray");

}  // namespace zproof::oracle
