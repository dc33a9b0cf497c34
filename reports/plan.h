/// A plan of a run for many machines: which of them judges which views.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

/// A scene, and the shard of each of its views. Without views (it could not be read, or has no triangles) it
/// has one shard all the same, which says so.
struct PlannedScene {
    std::string scene;               ///< as reports call it
    std::vector<std::string> views;  ///< as reports call them
    std::vector<int> shards;         ///< of each view, from 1 on
    double setup_s = 0;              ///< expected seconds before its first view
    std::vector<double> view_s;      ///< expected seconds of each view
};

/// What one renderer is asked.
struct PlannedRun {
    std::string name;               ///< the profile of zproof.toml; empty where the plan has no other run
    std::vector<std::string> argv;  ///< of the run as if it were one, with all its settings, without "zproof"
    Selection selection;
    std::vector<PlannedScene> scenes;  ///< one per scene of the selection, in its order
};

struct Plan {
    static constexpr int format_version = 1;
    std::string version, commit;  ///< of the zproof that runs it
    int shards = 1;
    std::vector<PlannedRun> runs;
    std::string sha256{};  ///< of its file; empty until it has one
};

/// Its JSON (docs/scale.md).
std::string to_json(const Plan& plan);

/// Throws ReportError where the file cannot be read or is no plan.
Plan read_plan(const std::filesystem::path& file);

}  // namespace zproof
