/// What one renderer saw through every pixel centre (x + 0.5, y + 0.5). Nothing here knows who rendered it.
#pragma once

#include <cstdint>
#include <limits>

#include "frame/attributes.h"
#include "frame/plane.h"

namespace zproof {

/// Index of a triangle in the baked scene. A type of its own: never a float, never arithmetic.
enum class PrimitiveId : std::uint32_t { none = 0xFFFF'FFFF };

inline constexpr float background_depth = std::numeric_limits<float>::infinity();

/// The AOVs of one view.
struct Frame {
    Plane<PrimitiveId> primitive;
    Plane<float> camera_depth;  ///< distance along the view axis, scene units, positive; +inf = background
    Attributes attributes;      ///< those that the renderer gives

    /// An all-background frame.
    explicit Frame(Resolution size)
        : primitive(size, PrimitiveId::none), camera_depth(size, background_depth) {}
    Frame() = default;

    /// A frame without values, for a caller that writes every pixel.
    static Frame unwritten(Resolution size) {
        Frame frame;
        frame.primitive = Plane<PrimitiveId>::unwritten(size);
        frame.camera_depth = Plane<float>::unwritten(size);
        return frame;
    }

    Resolution size() const { return primitive.size(); }
};

}  // namespace zproof
