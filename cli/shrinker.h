/// Random scenes that fail, made smaller for as long as they fail (docs/random.md).
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "cli/scene_run.h"
#include "program/scene_selection.h"
#include "reports/results.h"

namespace zproof {

class Shrinker {
  public:
    explicit Shrinker(const RunConfig& config) : config_(config) {}

    /// Shrinks a random scene whose failure is none of those before: writes the smaller one into the run's
    /// folder, below shrunk/, and notes it in the result. Does so for three failures at most. An interrupt
    /// ends it, with the least so far. Uses the surrounding tbb::task_arena.
    void look_at(const SceneSource& source, ViewResult& result);

  private:
    const RunConfig& config_;
    std::set<std::string> seen_;  ///< failures
};

/// What became of the failures, and the commands that show them, a few lines for each. Commands name the
/// folder `planned`; they are told with the one that is there.
std::string shrunk_in_words(const Results& results, const std::filesystem::path& planned,
                            const std::filesystem::path& folder);

}  // namespace zproof
