// The stand-in for TBB under ThreadSanitizer (CONTRIBUTING.md). Debian's TBB is not instrumented:
// ThreadSanitizer does not see how it hands work from thread to thread, and reports races where there are
// none. Here a loop starts threads and joins them, which ThreadSanitizer does see. What starts a loop happens
// before its bodies, and they happen before its end. Nothing else is ordered: chunks are handed out by
// relaxed atomics.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace tbb::stand_in {

/// How many threads a loop runs on, as the surrounding task_arena says. More than the cores on a small
/// machine.
inline thread_local int concurrency = 4;

/// Calls work(k) for every k < threads, each on a thread of its own, the first on the caller's. Rethrows the
/// exception of the lowest k that threw.
template <typename Work>
void run_threads(std::size_t threads, const Work& work) {
    std::vector<std::exception_ptr> failures(threads);
    const auto run = [&](std::size_t k, int allowed) noexcept {
        concurrency = allowed;
        try {
            work(k);
        } catch (...) {
            failures[k] = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    for (std::size_t k = 1; k < threads; ++k) others.emplace_back(run, k, concurrency);
    run(0, concurrency);
    for (std::thread& other : others) other.join();
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

/// Calls act(chunk) for every chunk < count. Each thread is sure of one chunk; the others go to whoever asks
/// first. A thread yields after each, so that no thread takes them all.
template <typename Act>
void for_each_chunk(std::size_t count, const Act& act) {
    const std::size_t threads = std::min(count, std::size_t(concurrency));
    if (threads == 0) return;
    std::atomic<std::size_t> next = threads;
    run_threads(threads, [&](std::size_t first) {
        for (std::size_t chunk = first; chunk < count; chunk = next.fetch_add(1, std::memory_order_relaxed)) {
            act(chunk);
            std::this_thread::yield();
        }
    });
}

}  // namespace tbb::stand_in
