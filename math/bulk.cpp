#include "math/bulk.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>

namespace zproof {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

std::size_t rounded_up(std::size_t bytes) { return (bytes + huge_page - 1) / huge_page * huge_page; }

}  // namespace

void prefer_huge_pages(void* memory, std::size_t bytes) noexcept {
    const std::size_t to_first =
        (huge_page - reinterpret_cast<std::uintptr_t>(memory) % huge_page) % huge_page;
    if (bytes < to_first + huge_page) return;
    madvise(static_cast<char*>(memory) + to_first, (bytes - to_first) / huge_page * huge_page, MADV_HUGEPAGE);
}

void* allocate_bulk(std::size_t bytes) {
    const bool is_huge = bytes >= huge_page && rounded_up(bytes) >= bytes;
    void* memory = is_huge ? std::aligned_alloc(huge_page, rounded_up(bytes)) : std::malloc(bytes);
    if (memory == nullptr) throw std::bad_alloc();
    if (is_huge) prefer_huge_pages(memory, rounded_up(bytes));
    return memory;
}

void free_bulk(void* memory) noexcept { std::free(memory); }

}  // namespace zproof
