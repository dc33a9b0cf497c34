/// Is there memory for a view? Asked before anything is allocated.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "frame/plane.h"

namespace zproof {

/// What this process may still take: the least of what the machine has left (MemAvailable and SwapFree of
/// /proc/meminfo), what its own limit (RLIMIT_AS) and what its control groups leave it.
std::uint64_t available_memory_bytes();

/// What the control groups (cgroup v2) of a process leave it: the least of memory.max less what is in use and
/// cannot be dropped, of its own group and those above. `groups`: /proc/PID/cgroup; `root`: where the groups'
/// folders are. Swap is not counted. The largest number where none has a limit.
std::uint64_t memory_left_of_groups(const std::string& groups, const std::filesystem::path& root);

/// What the frames of candidate and reference and the verdict of such a view take at the least. A run takes
/// more.
std::uint64_t least_memory_bytes(Resolution size);

/// Why a view of this size cannot be rendered: what it needs, what there is, and a remedy. Empty where it
/// can.
std::string lacking_memory(Resolution size);

/// Throws std::runtime_error with these words.
void require_memory(Resolution size);

/// What to say where memory ran out in spite of that.
std::string out_of_memory(Resolution size, std::uint64_t triangles);
/// What is told where memory ran out while a scene was read or built.
std::string out_of_memory_for(const std::string& scene);

}  // namespace zproof
