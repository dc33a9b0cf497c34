/// What becomes of an output folder that another one has replaced.
#pragma once

#include <filesystem>
#include <vector>

namespace zproof {

/// Removes from `old` what its list names and what is as it was written; moves everything else into `path`,
/// under its own name or NAME.kept. Returns where that lies now. What can be neither removed nor moved stays
/// in `old`.
std::vector<std::filesystem::path> retire(const std::filesystem::path& old,
                                          const std::filesystem::path& path);

/// Looks for PATH.tmp-PID and PATH.old-PID that nobody holds a lock on: their processes are dead. An
/// unfinished one is removed, a finished one takes PATH's place where that is free, or is retired. Returns
/// what was kept.
std::vector<std::filesystem::path> tidy_up_beside(const std::filesystem::path& path);

}  // namespace zproof
