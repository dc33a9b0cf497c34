/// Are the values that a renderer interpolated over its triangles within their bounds? (docs/bounds.md,
/// "Attributes")
#pragma once

#include <optional>

#include "compare/bounds/bounds.h"
#include "compare/bounds/pixel_coord.h"
#include "frame/frame.h"
#include "scenes/scene.h"

namespace zproof {

/// A value that no faultless renderer gives.
struct WrongAttribute {
    const char* channel;  ///< as in files: "b1", "u", "Px"
    float value;
    double low, high;  ///< what is admissible; in double, for people
};

class AttributeCheck {
  public:
    /// Everything must outlive it.
    AttributeCheck(const Scene& scene, const View& view, const ViewBounds& bounds, const Precision& precision)
        : scene_(scene), view_(view), bounds_(bounds), precision_(precision) {}

    /// The first wrong value at a pixel whose triangle is admissible there and whose depth is right; nothing
    /// where all values are within their bounds, or where the precision promises nothing about them. In
    /// double with an error bound, then by rationals.
    std::optional<WrongAttribute> first_wrong(const Frame& frame, const PixelCoord& pixel) const;

  private:
    const Scene& scene_;
    const View& view_;
    const ViewBounds& bounds_;
    const Precision& precision_;
};

}  // namespace zproof
