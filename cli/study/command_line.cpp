#include "cli/study/command_line.h"

#include <CLI/CLI.hpp>

#include "cli/command_line/options.h"
#include "cli/study/study.h"
#include "cli/usage_error.h"

namespace zproof {
namespace {

std::string list_of(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

void add_common(CLI::App& app, const Study& study, StudyArguments& arguments) {
    app.add_option("SCENE", arguments.scenes,
                   "suite or filter scene, model (.gltf, .glb, .obj, .ply) or view file; none: " +
                       list_of(study.subjects));
    add_common(app, arguments.common, "folder for the study");
    add_progress(app, arguments.common);
    app.add_option("--view", arguments.views,
                   "names of views, separated by commas; default: all of every scene")
        ->delimiter(',');
    app.add_option("--width", arguments.width,
                   "pixels; default " + std::to_string(study.resolution.width) + "; view files state theirs")
        ->check(CLI::Range(1, 32768));
    app.add_option("--height", arguments.height,
                   "pixels; default " + std::to_string(study.resolution.height) + "; view files state theirs")
        ->check(CLI::Range(1, 32768));
    add_isa(app);
}

}  // namespace

void add_study(CLI::App& app, StudyArguments& arguments) {
    app.require_subcommand(0, 1);
    for (const Study& study : studies()) {
        CLI::App& own = *app.add_subcommand(study.name, study.purpose);
        add_common(own, study, arguments);
        if (study.add_options) study.add_options(own, arguments);
    }
}

StudyArguments chosen_study(const CLI::App& app, StudyArguments& arguments) {
    std::vector<std::string> names;
    for (const Study& study : studies()) {
        names.push_back(study.name);
        if (app.get_subcommand(study.name)->parsed()) arguments.study = study.name;
    }
    if (arguments.study.empty())
        throw UsageError{"study: one of " + list_of(names) + " expected (see: zproof study --help)"};
    return arguments;
}

}  // namespace zproof
