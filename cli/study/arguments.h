/// zproof study as typed values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/settings.h"

namespace CLI {
class App;
}

namespace zproof {

/// What every study is asked with. A study's own wishes get a member of their own here.
struct StudyArguments {
    std::string study;                 ///< Study::name
    std::vector<std::string> scenes;   ///< empty: the study's own
    std::vector<std::string> views;    ///< empty: all of every scene
    std::optional<int> width, height;  ///< pixels; none: the study's own; view files state theirs
    int threads = available_threads();
    std::filesystem::path out = "zproof-study";
    ProgressStyle progress = ProgressStyle::automatic;
    std::string typed;  ///< the command line, quoted for a shell
};

}  // namespace zproof
