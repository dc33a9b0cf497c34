/// Ids as the numbers that they are.
#pragma once

#include <cstdint>
#include <span>

#include "frame/frame.h"

namespace zproof::api {

static_assert(sizeof(PrimitiveId) == sizeof(std::uint32_t));

inline std::span<const std::uint32_t> ids_of(const zproof::Frame& frame) {
    const std::span<const PrimitiveId> ids = frame.primitive.pixels();
    return {reinterpret_cast<const std::uint32_t*>(ids.data()), ids.size()};  // NOLINT: the enum's own type
}

}  // namespace zproof::api
