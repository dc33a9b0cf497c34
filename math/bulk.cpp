#include "math/bulk.h"

#include <sys/mman.h>
#include <tbb/scalable_allocator.h>

#include <cstdint>
#include <cstdlib>

namespace zproof {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

std::size_t rounded_up(std::size_t bytes, std::size_t to) { return (bytes + to - 1) / to * to; }

/// The last huge page of several is worth it where no more than that of it stays unused: the small ones that
/// it stands for take fifty times as long to come by, but memory is what images have most of.
constexpr std::size_t most_unused = huge_page * 3 / 8;

/// The least size kept, bytes. The C library has enough smaller blocks at hand.
constexpr std::size_t kept_from = std::size_t{1} << 16;

/// AddressSanitizer watches the ends of what the C library gives.
#ifdef __SANITIZE_ADDRESS__
constexpr bool is_watched = true;
#else
constexpr bool is_watched = false;
#endif

/// Is a huge page come by faster than the small ones that it stands for?
bool is_huge(std::size_t bytes) { return bytes >= huge_page / 4 && rounded_up(bytes, huge_page) >= bytes; }

/// Would the C library give it back to the system as soon as it is free?
bool is_kept(std::size_t bytes) { return !is_watched && bytes >= kept_from; }

void* allocate_huge(std::size_t bytes) {
    const std::size_t size = rounded_up(bytes, huge_page);
    void* const memory =
        is_watched ? std::aligned_alloc(huge_page, size) : scalable_aligned_malloc(size, huge_page);
    const bool fills_the_last = bytes < huge_page || size - bytes <= most_unused;
    if (memory != nullptr) prefer_huge_pages(memory, fills_the_last ? size : bytes);
    return memory;
}

void* allocate_small(std::size_t bytes, std::size_t alignment) {
    const std::size_t size = rounded_up(bytes, alignment);
    if (size < bytes) return nullptr;
    return is_kept(bytes) ? scalable_aligned_malloc(size, alignment) : std::aligned_alloc(alignment, size);
}

}  // namespace

void prefer_huge_pages(void* memory, std::size_t bytes) noexcept {
    const std::size_t to_first =
        (huge_page - reinterpret_cast<std::uintptr_t>(memory) % huge_page) % huge_page;
    if (bytes < to_first + huge_page) return;
    madvise(static_cast<char*>(memory) + to_first, (bytes - to_first) / huge_page * huge_page, MADV_HUGEPAGE);
}

void* allocate_bulk(std::size_t bytes, std::size_t alignment) {
    void* const memory = is_huge(bytes) ? allocate_huge(bytes) : allocate_small(bytes, alignment);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

void free_bulk(void* memory, std::size_t bytes) noexcept {
    is_kept(bytes) ? scalable_aligned_free(memory) : std::free(memory);
}

}  // namespace zproof
