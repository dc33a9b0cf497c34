#pragma once

namespace zproof {

/// From now on memory that is freed stays with the program, for whatever asks next: a run makes and drops the
/// same planes view after view, and a page that comes back from the system is cleared first, 4 KiB at a time.
/// What lies between pieces in use counts as memory in use. Does nothing where the C library is not glibc.
void keep_freed_memory() noexcept;

}  // namespace zproof
