/// zproof study as typed values, and what it does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "program/common_arguments.h"
#include "program/exit_code.h"

namespace zproof {

/// Whose pictures a study asks for beside our own.
enum class StudyOracles {
    all,     ///< POV-Ray too, where it is installed
    embree,  ///< what is always there
};

struct ProjectionOptions {
    int vertices = 4096;  ///< at most so many of a view are studied
    StudyOracles oracles = StudyOracles::all;
};

/// The depth study's own. None: the first view's planes, and no gap.
struct DepthOptions {
    std::optional<double> near, far, gap;  ///< scene units
};

/// The cost study's own.
struct CostOptions {
    int repeats = 5;  ///< measured runs for each time
};

/// What every study is asked with. A study's own options get a member of their own here.
struct StudyArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-study"};
    std::string study;                 ///< Study::name
    std::vector<std::string> scenes;   ///< empty: the study's own
    std::vector<std::string> views;    ///< empty: all of every scene
    std::optional<int> width, height;  ///< pixels; none: the study's own; view files state theirs
    std::string typed;                 ///< the command line, quoted for a shell
    ProjectionOptions projection;
    DepthOptions depth;
    CostOptions cost;
};

/// Performs a study and writes its folder, terminal table included (lessons/study.h). SceneError for a
/// scene that there is not. An interrupt ends it after the view in hand; what was done is written.
ExitCode execute(const StudyArguments& arguments);

}  // namespace zproof
