#include "scenes/bulk.h"

#include <sys/mman.h>

#include <cstdlib>

namespace zproof {
namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

/// Below this a huge page would be mostly empty.
constexpr std::size_t worth_huge_pages = 2 * huge_page;

}  // namespace

void* allocate_bulk(std::size_t bytes) {
    const std::size_t rounded = (bytes + huge_page - 1) / huge_page * huge_page;
    const bool is_huge = bytes >= worth_huge_pages && rounded >= bytes;
    void* memory = is_huge ? std::aligned_alloc(huge_page, rounded) : std::malloc(bytes);
    if (memory == nullptr) throw std::bad_alloc();
    if (is_huge) madvise(memory, rounded, MADV_HUGEPAGE);  // where refused, ordinary pages do
    return memory;
}

void free_bulk(void* memory) noexcept { std::free(memory); }

}  // namespace zproof
