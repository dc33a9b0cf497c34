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

/// One number of an attribute as somebody reads it, and what it would interpolate.
struct ReadValue {
    std::size_t channel = 0;
    std::array<double, 3> at_corners{};
    float value = 0;
    double further_slack = 0;  ///< what reading it costs, beside the declared arithmetic
};

/// One attribute at a pixel, by axis, over a triangle.
struct AttributeValues {
    CornersWorld p_world{};
    std::vector<ReadValue> values;
    /// By axis: what each number may be instead. Empty: `values` alone.
    std::vector<std::vector<ReadValue>> alternatives{};
};

/// What is said of a pixel's attributes.
struct CheckedAttributes {
    std::optional<WrongAttribute> wrong{};  ///< the first one; nothing where all are within their bounds
    bool is_open = false;                   ///< the precision leaves open what they are: none can be wrong
};

class AttributeCheck {
  public:
    /// Scene and frame must outlive it.
    AttributeCheck(const Scene& scene, const View& view, const Frame& frame, const Precision& precision);

    /// At a pixel whose triangle is admissible and whose depth is right; at background, and where nothing is
    /// judged, nothing is wrong or open. In double with an error bound, then by rationals.
    CheckedAttributes at(const PixelCoord& pixel) const;

    /// As the frame tells them, and the scene holds them at the triangle's corners.
    AttributeValues values_at(const PixelCoord& pixel, Attribute attribute) const;
    /// Are they within their bounds, by the same rule?
    bool are_admissible(const PixelCoord& pixel, const AttributeValues& values) const;
    const std::vector<Attribute>& judged() const { return judged_; }

  private:
    SampledSurface sampled_from(const Surface& surface) const;

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
