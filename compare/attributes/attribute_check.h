/// Are the values that a renderer interpolated over its triangles within their bounds? (docs/bounds.md,
/// "Attributes")
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/attributes/interpolated_value.h"
#include "compare/attributes/wrong_attribute.h"
#include "compare/bounds/bounds.h"
#include "compare/bounds/pixel_coord.h"
#include "compare/bounds/view_facts.h"
#include "frame/frame.h"

namespace zproof {

class AttributeCheck {
  public:
    /// Scene and frame must outlive it.
    AttributeCheck(const Scene& scene, const View& view, const Frame& frame, const Precision& precision);

    /// The first wrong value at a pixel whose triangle is admissible there and whose depth is right; nothing
    /// where all values are within their bounds, at background, and where nothing is judged. In double with
    /// an error bound, then by rationals.
    std::optional<WrongAttribute> first_wrong(const PixelCoord& pixel) const;

  private:
    const Scene& scene_;
    ViewFacts facts_;
    const Frame& frame_;
    Precision precision_;
    ViewBounds varying_bounds_, shown_bounds_;
    std::vector<Attribute> judged_;
};

/// The attributes that a frame gives and that are judged.
std::vector<Attribute> judged_attributes(const Scene& scene, const View& view, const Attributes& given,
                                         const Precision& precision);

/// The attributes that a frame gives and nobody can judge, each with its reason: "normal: the scene has
/// none".
std::vector<std::string> unjudged_attributes(const Scene& scene, const View& view, const Attributes& given,
                                             const Precision& precision);

}  // namespace zproof
