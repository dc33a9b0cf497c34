/// Ways in which a renderer's attributes may have gone wrong: what each told value is read as
/// (docs/diagnosis.md, "Attributes").
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compare/attributes/attribute_check.h"
#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// What a reading may ask of the pixel.
struct AttributePixel {
    const Scene& scene;
    const View& view;
    std::uint32_t triangle;
};

struct AttributeReading {
    Cause cause;
    /// One attribute's values, by axis, as they would be if they were read so; nothing where they cannot be
    /// meant so.
    std::function<std::optional<AttributeValues>(const AttributePixel&, AttributeValues)> read;
};

/// All readings of an attribute, the more specific first.
std::vector<AttributeReading> readings_of(Attribute attribute, const Scene& scene, const View& view);

}  // namespace zproof
