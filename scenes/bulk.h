/// Arrays of many elements.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace zproof {

/// Memory for `bytes` bytes; where that is several MiB, the system is asked for huge pages. Throws
/// std::bad_alloc.
void* allocate_bulk(std::size_t bytes);
void free_bulk(void* memory) noexcept;

/// Three things are unlike std::allocator. Elements that nobody gives a value to stay unwritten, where their
/// type allows that: resize() clears nothing, so that several threads can write them, and nobody writes them
/// twice. Several MiB stand in huge pages, which take a thousandth of the time to come by. And there are
/// `padding` bytes behind the last element, of unspecified content, so that a 16-byte load may read the last
/// glm::vec3, as Embree does with shared vertex buffers (Embree API, rtcSetSharedGeometryBuffer).
template <class T>
struct BulkAllocator {
    using value_type = T;
    static constexpr std::size_t padding = 16;

    BulkAllocator() = default;
    template <class U>
    constexpr BulkAllocator(const BulkAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocate_bulk(count * sizeof(T) + padding)); }
    void deallocate(T* values, std::size_t) noexcept { free_bulk(values); }
    template <class U>
    void construct(U* value) noexcept {
        ::new (static_cast<void*>(value)) U;
    }
    bool operator==(const BulkAllocator&) const = default;
};

template <class T>
using Bulk = std::vector<T, BulkAllocator<T>>;

}  // namespace zproof
