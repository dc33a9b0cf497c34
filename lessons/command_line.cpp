#include "lessons/command_line.h"

#include <CLI/CLI.hpp>
#include <array>

#include "frame/joined.h"
#include "lessons/study.h"
#include "program/command_line/common_options.h"
#include "program/command_line/companion_tree.h"
#include "program/command_line/parsing.h"
#include "program/shell_line.h"
#include "program/usage_error.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

constexpr auto examples = std::to_array<Example>({
    {"study", "zproof study projection model.glb -o study", "every route from world to pixel"},
    {"study", "zproof study depth -o depth", "what each depth format can tell apart"},
    {"study", "zproof study cost -o cost", "what a frame costs, and what it should"},
    {"study projection", "zproof study projection",
     "two scenes of the suite, every route from world to pixel"},
    {"study projection", "zproof study projection model.glb -o study", "a scene of your own"},
    {"study depth", "zproof study depth -o depth", "what each depth format can tell apart"},
    {"study shading", "zproof study shading -o shading", "what interpolation does to light"},
    {"study cost", "zproof study cost -o cost", "what a frame costs, and what it should"},
});

Candidates scenes(const std::string&) {
    Candidates candidates{{}, Paths::files, Listing::single};
    for (const SuiteEntry& entry : suite_manifest()) candidates.words.push_back(entry.name);
    for (const SuiteEntry& entry : thorough_manifest()) candidates.words.push_back(entry.name);
    return candidates;
}

constexpr std::array kinds{ValueKind{"SCENE", scenes}};

void add_common(CLI::App& app, const Study& study, StudyArguments& arguments) {
    app.add_option("SCENE", arguments.scenes,
                   "suite or filter scene, model (.gltf, .glb, .obj, .ply) or view file; none: " +
                       joined(study.subjects));
    add_common(app, arguments.common, "folder for the study");
    add_progress(app, arguments.common);
    app.add_option("--view", arguments.views,
                   "names of views, separated by commas; default: all of every scene")
        ->type_name("VIEW")
        ->delimiter(',');
    app.add_option("--width", arguments.width,
                   "pixels; default " + std::to_string(study.resolution.width) + "; view files state theirs")
        ->check(CLI::Range(1, 32768));
    app.add_option("--height", arguments.height,
                   "pixels; default " + std::to_string(study.resolution.height) + "; view files state theirs")
        ->check(CLI::Range(1, 32768));
    add_isa(app);
}

void add_study(CLI::App& app, StudyArguments& arguments) {
    for (const Study& study : studies()) {
        CLI::App& own = *app.add_subcommand(study.name, study.purpose);
        add_common(own, study, arguments);
        if (study.add_options) study.add_options(own, arguments);
    }
}

/// The study that was typed. Throws UsageError where none was.
StudyArguments chosen_study(const CLI::App& app, StudyArguments& arguments) {
    std::vector<std::string> names;
    for (const Study& study : studies()) {
        names.push_back(study.name);
        if (app.get_subcommand(study.name)->parsed()) arguments.study = study.name;
    }
    if (arguments.study.empty())
        throw UsageError{"study: one of " + joined(names) + " expected (see: zproof study --help)"};
    return arguments;
}

}  // namespace

Command parse_study(int argc, const char* const* argv, const Environment& environment) {
    StudyArguments arguments;
    std::vector<std::string> typed{argv + 1, argv + argc};
    typed.insert(typed.begin(), "study");
    arguments.typed = shell_line(typed);
    CompanionTree tree{"study", examples, kinds};
    add_study(tree.root(), arguments);
    if (auto answer = tree.answer(argc, argv)) return *answer;
    take_settings(tree.root(), {}, environment);
    return command_of(chosen_study(tree.root(), arguments), "cannot study");
}

}  // namespace zproof
