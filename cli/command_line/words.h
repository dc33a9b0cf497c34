/// What is bound while a command line is read.
#pragma once

#include <functional>
#include <string>

#include "cli/arguments.h"
#include "cli/renderer_words.h"

namespace CLI {
class App;
}

namespace zproof {

/// Every command's arguments with their defaults; an option writes into them as it is read.
struct CommandWords {
    RendererWords renderers;
    RunArguments run;
    RandomChoice random;
    CompareArguments compare;
    ExplainArguments explain;
    RenderArguments render;
    MeasureArguments measure;
    FitArguments fit;
    SelfcheckArguments selfcheck;
    ConformanceArguments conformance;
    ContractCheckArguments contract_check;
    SelftestArguments selftest;
    GenerateArguments generate;
    RandomScenesArguments random_scenes;
    ViewsArguments views;
    InitArguments init;
    glm::ivec2 image_size{0, 0};  ///< --width, --height of views
    MergeArguments merge;
    PlanArguments plan;
    std::vector<std::string> plan_profiles;
    std::string shard;        ///< of run; empty: all of it
    Environment environment;  ///< that `--shard auto` asks
    ReportAgainArguments report_again;
    DiffResultsArguments diff_results;
    WaiveListArguments waive_list;
    WaiveCheckArguments waive_check;
    WaivePruneArguments waive_prune;
    WaiveAddArguments waive_add;
    DoctorArguments doctor;
    ListArguments list;
    Answered completion, manual;
    SettingsChoice settings;  ///< --config, --profile
    std::string shell;        ///< whose completion
};

}  // namespace zproof
