/// Memory with readable bytes behind the last element.
#pragma once

#include <cstddef>
#include <new>

namespace zproof {

/// Allocates `padding` bytes more than asked for, so that the last element may be read by a 16-byte SSE load,
/// as Embree does with shared vertex buffers (Embree API, rtcSetSharedGeometryBuffer). The content of the
/// padding is unspecified.
template <class T>
struct PaddedAllocator {
    using value_type = T;
    static constexpr std::size_t padding = 16;

    PaddedAllocator() = default;
    template <class U>
    constexpr PaddedAllocator(const PaddedAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T) + padding)); }
    void deallocate(T* values, std::size_t) noexcept { ::operator delete(values); }
    bool operator==(const PaddedAllocator&) const = default;
};

}  // namespace zproof
