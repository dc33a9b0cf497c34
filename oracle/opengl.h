/// OpenGL as a renderer and a reference: whatever driver EGL finds without a window, Mesa's llvmpipe on a
/// machine without a GPU.
///
/// Triangle i of the scene is primitive i of one draw call; the fixed-function rasterizer, clipper and depth
/// test do the rest. The depth test is `GREATER` on a reversed z, so that of two equal depths the triangle
/// drawn first stays: the one with the smaller id. Both faces are drawn. Depth comes out of the z-buffer
/// (oracle/clip_space.h).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// A driver at work, for scenes that are drawn once. Copies share it; one view is drawn at a time, and any
/// thread may ask. The driver keeps threads of its own, as many as it likes.
class OpenGlDriver {
  public:
    /// Throws OracleError where opengl_is_missing gives a reason.
    OpenGlDriver();

    /// Renders as OpenGl::render does.
    Frame render(const Scene& scene, const View& view) const;
    /// What OpenGL promises (docs/bounds.md), with the sub-pixel bits that the driver gives for
    /// GL_SUBPIXEL_BITS.
    Precision precision() const;
    /// The driver's vendor, renderer and version strings in one line, for the report.
    std::string version() const;

  private:
    friend class OpenGl;
    struct State;
    std::shared_ptr<const State> state_;
};

/// A scene in the driver's memory, copied there. Threads as with the driver.
class OpenGl {
  public:
    /// Throws OracleError where there is no driver, or in the driver's words where it refuses the scene.
    explicit OpenGl(const Scene& scene, const OpenGlDriver& driver = {});
    ~OpenGl();
    OpenGl(OpenGl&&) noexcept;
    OpenGl& operator=(OpenGl&&) noexcept;

    /// Throws OracleError where the image is larger than the driver's largest, or the driver reports an
    /// error. Pixels are as the driver left them: a NaN that it wrote is a NaN in the frame.
    Frame render(const View& view) const;

  private:
    struct Model;
    std::unique_ptr<Model> model_;
};

/// Why there is no OpenGL, in one line ("OpenGL: not built in", or what EGL said); nothing where there is.
std::optional<std::string> opengl_is_missing();

}  // namespace zproof::oracle
