/// Arrays of many elements.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace zproof {

/// Asks the system for huge pages where the memory has room for some; nothing is lost where it refuses. A
/// page of 2 MiB takes about as long to come by as a dozen of the 512 that it stands for.
void prefer_huge_pages(void* memory, std::size_t bytes) noexcept;

/// Memory for `bytes` bytes, in huge pages where that is 512 KiB or more; from 64 KiB on it comes from TBB,
/// which keeps what is freed for a while and gives it out again with its pages. Its address is a multiple of
/// `alignment`, a power of two up to 4096. Throws std::bad_alloc.
void* allocate_bulk(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t));
/// Takes what allocate_bulk() gave for as many bytes.
void free_bulk(void* memory, std::size_t bytes) noexcept;

/// Unlike with std::allocator, elements that nobody gives a value to stay unwritten where they can be copied
/// byte by byte: resize() clears nothing that is about to be written.
template <class T>
struct BulkAllocator {
    using value_type = T;

    BulkAllocator() = default;
    template <class U>
    constexpr BulkAllocator(const BulkAllocator<U>&) noexcept {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocate_bulk(count * sizeof(T), alignment)); }
    void deallocate(T* values, std::size_t count) noexcept { free_bulk(values, count * sizeof(T)); }
    template <class U>
    void construct(U* value) noexcept {
        if constexpr (!std::is_trivially_copyable_v<U>) ::new (static_cast<void*>(value)) U;
    }
    bool operator==(const BulkAllocator&) const = default;

  private:
    static constexpr std::size_t alignment = std::max(alignof(T), alignof(std::max_align_t));
};

template <class T>
using Bulk = std::vector<T, BulkAllocator<T>>;

}  // namespace zproof
