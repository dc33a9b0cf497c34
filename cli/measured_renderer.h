/// A renderer as an instrument reads it: any scene, any view.
#pragma once

#include "cli/renderers/choice.h"
#include "measure/renderer.h"

namespace zproof {

/// Throws FrameError where what it declares cannot be understood; its pictures throw what open() throws.
measure::Renderer measured_renderer(const RendererChoice& choice);

}  // namespace zproof
