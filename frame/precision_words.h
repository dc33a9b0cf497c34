/// The words of a declaration's values. Values run from 0; behind the last of a type there is no word.
#pragma once

#include <string_view>

#include "frame/precision.h"

namespace zproof {

constexpr std::string_view word_of(Arithmetic value) {
    switch (value) {
        case Arithmetic::float32:
            return "float32";
        case Arithmetic::float64:
            return "float64";
    }
    return {};
}

constexpr std::string_view word_of(Origin value) {
    switch (value) {
        case Origin::world:
            return "world";
        case Origin::eye:
            return "eye";
    }
    return {};
}

constexpr std::string_view word_of(Snap value) {
    switch (value) {
        case Snap::nearest:
            return "nearest";
        case Snap::truncate:
            return "truncate";
        case Snap::none:
            return "none";
    }
    return {};
}

constexpr std::string_view word_of(EdgeFunctions value) {
    switch (value) {
        case EdgeFunctions::exact:
            return "exact";
        case EdgeFunctions::from_corner:
            return "from_corner";
        case EdgeFunctions::homogeneous:
            return "homogeneous";
        case EdgeFunctions::window_coefficients:
            return "window_coefficients";
    }
    return {};
}

constexpr std::string_view word_of(ThirdWeight value) {
    switch (value) {
        case ThirdWeight::edge_function:
            return "edge_function";
        case ThirdWeight::remainder:
            return "remainder";
    }
    return {};
}

constexpr std::string_view word_of(Clipping value) {
    switch (value) {
        case Clipping::guard_band:
            return "guard_band";
        case Clipping::view_volume:
            return "view_volume";
    }
    return {};
}

constexpr std::string_view word_of(DepthBuffer value) {
    switch (value) {
        case DepthBuffer::camera_depth:
            return "camera_depth";
        case DepthBuffer::reversed_z:
            return "reversed_z";
        case DepthBuffer::standard_z:
            return "standard_z";
    }
    return {};
}

constexpr std::string_view word_of(DepthFormat value) {
    switch (value) {
        case DepthFormat::float32:
            return "float32";
        case DepthFormat::float64:
            return "float64";
        case DepthFormat::unorm16:
            return "unorm16";
        case DepthFormat::unorm24:
            return "unorm24";
        case DepthFormat::unorm32:
            return "unorm32";
    }
    return {};
}

constexpr std::string_view word_of(DepthRounding value) {
    switch (value) {
        case DepthRounding::either:
            return "either";
        case DepthRounding::nearest:
            return "nearest";
        case DepthRounding::truncate:
            return "truncate";
    }
    return {};
}

constexpr std::string_view word_of(ClipRange value) {
    switch (value) {
        case ClipRange::zero_to_one:
            return "zero_to_one";
        case ClipRange::minus_one_to_one:
            return "minus_one_to_one";
    }
    return {};
}

constexpr std::string_view word_of(MatrixFar value) {
    switch (value) {
        case MatrixFar::infinite:
            return "infinite";
        case MatrixFar::finite:
            return "finite";
    }
    return {};
}

constexpr std::string_view word_of(DepthInterpolation value) {
    switch (value) {
        case DepthInterpolation::barycentrics:
            return "barycentrics";
        case DepthInterpolation::plane:
            return "plane";
    }
    return {};
}

constexpr std::string_view word_of(ShownDepth value) {
    switch (value) {
        case ShownDepth::buffer:
            return "buffer";
        case ShownDepth::varying:
            return "varying";
    }
    return {};
}

constexpr std::string_view word_of(RayTest value) {
    switch (value) {
        case RayTest::pluecker:
            return "pluecker";
        case RayTest::moeller_trumbore:
            return "moeller_trumbore";
        case RayTest::woop:
            return "woop";
    }
    return {};
}

constexpr std::string_view word_of(HitPoint value) {
    switch (value) {
        case HitPoint::distance:
            return "distance";
        case HitPoint::barycentrics:
            return "barycentrics";
    }
    return {};
}

}  // namespace zproof
