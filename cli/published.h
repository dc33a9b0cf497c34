/// The end of every command that leaves a folder.
#pragma once

#include <filesystem>

#include "reports/output_folder.h"

namespace zproof {

/// Puts the folder in its place, or a partial one beside the last full one. Says on stderr which, and what it
/// keeps there though zproof did not write it. Returns where the folder is, by the name that was typed for
/// it.
std::filesystem::path publish(OutputFolder& folder, const std::filesystem::path& typed,
                              Completeness completeness = Completeness::full);

}  // namespace zproof
