#include "math/bulk.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace zproof {
namespace {

/// Below and above what TBB gives, and what stands in huge pages.
constexpr std::size_t sizes[] = {1,       100,     65'535,  65'536,    65'537,   200'000,
                                 524'287, 524'288, 600'000, 2'097'152, 5'000'000};

TEST(Bulk, MemoryIsAlignedAndAllOfItMayBeWritten) {
    for (const std::size_t alignment : {std::size_t{16}, std::size_t{64}, std::size_t{4096}})
        for (const std::size_t bytes : sizes) {
            void* const memory = allocate_bulk(bytes, alignment);
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % alignment, 0u) << bytes;
            std::memset(memory, 0xA5, bytes);
            free_bulk(memory, bytes);
        }
}

/// Vectors of a processor are written as such only where they stand at their multiples.
TEST(Bulk, ElementsStandWhereTheirTypeWants) {
    struct alignas(64) Wide {
        double values[8];
    };
    for (const std::size_t bytes : sizes) {
        const Bulk<Wide> wide(bytes / sizeof(Wide) + 1);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(wide.data()) % alignof(Wide), 0u) << bytes;
    }
}

}  // namespace
}  // namespace zproof
