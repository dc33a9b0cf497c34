/// The end of every command that leaves a folder.
#pragma once

#include <filesystem>

#include "program/common_arguments.h"
#include "reports/output_folder.h"

namespace zproof {

/// Puts the folder in its place (-o), or a partial one beside the last full one. Says on stderr which, and
/// what it keeps there though zproof did not write it, but not to -q. Returns where the folder is, by the
/// name that was typed for it.
std::filesystem::path publish(OutputFolder& folder, const CommonArguments& common,
                              Completeness completeness = Completeness::full);

}  // namespace zproof
