// Stand-in for TBB; see run_threads.h. The C library's memory: ThreadSanitizer knows when it changes hands.
#pragma once

#include <cstddef>
#include <cstdlib>

inline void* scalable_aligned_malloc(std::size_t size, std::size_t alignment) {
    return std::aligned_alloc(alignment, size);
}

inline void scalable_aligned_free(void* memory) { std::free(memory); }
