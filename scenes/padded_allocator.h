/// Memory with readable bytes behind the last element.
#pragma once

#include <cstddef>

#include "math/bulk.h"

namespace zproof {

/// Allocates `padding` bytes more than asked for, so that the last element may be read by a 16-byte SSE load,
/// as Embree does with shared vertex buffers (Embree API, rtcSetSharedGeometryBuffer). The content of the
/// padding is unspecified. As with BulkAllocator, elements that nobody gives a value to stay unwritten.
template <class T>
struct PaddedAllocator {
    using value_type = T;
    static constexpr std::size_t padding = 16;

    PaddedAllocator() = default;
    template <class U>
    constexpr PaddedAllocator(const PaddedAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocate_bulk(count * sizeof(T) + padding)); }
    void deallocate(T* values, std::size_t count) noexcept { free_bulk(values, count * sizeof(T) + padding); }
    template <class U>
    void construct(U* value) noexcept {
        BulkAllocator<U>().construct(value);
    }
    bool operator==(const PaddedAllocator&) const = default;
};

}  // namespace zproof
