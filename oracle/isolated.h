/// Work on what nobody trusts, done in a copy of this process: whatever becomes of the copy, this process
/// goes on.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace zproof::oracle {

/// Bytes of address space that this process has.
std::size_t address_space_bytes();

using Bytes = std::vector<std::byte>;

struct IsolationLimits {
    std::size_t memory_bytes;  ///< that the copy may have beyond what this process has
    std::chrono::milliseconds time;
};

/// What the work returns. Of the calling process only the calling thread lives on in the copy: the work must
/// wait for no other. Throws FrameError with the words of the FrameError that the work throws; and one that
/// begins with `name` where the copy throws anything else, is ended by a signal, or uses up a limit.
Bytes isolated(const std::string& name, const IsolationLimits& limits, const std::function<Bytes()>& work);

}  // namespace zproof::oracle
