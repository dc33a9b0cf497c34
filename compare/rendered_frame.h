/// A frame before the judge.
#pragma once

#include "compare/bounds/bounds.h"
#include "frame/frame.h"

namespace zproof {

/// A frame and what its renderer promises.
struct RenderedFrame {
    const Frame& frame;
    Precision precision;
};

/// A frame and what its renderer's promise means for the view.
struct BoundedFrame {
    BoundedFrame(const View& view, const RenderedFrame& rendered)
        : frame(rendered.frame),
          precision(rendered.precision),
          bounds(view, rendered.precision),
          shown_bounds(ViewBounds::of_shown(view, rendered.precision)) {}

    const Frame& frame;
    Precision precision;
    ViewBounds bounds;        ///< of what decides which triangle is shown
    ViewBounds shown_bounds;  ///< of the depths that the frame shows
};

/// What is compared.
struct FramePair {
    const Scene& scene;
    const View& view;
    BoundedFrame candidate, reference;
};

}  // namespace zproof
