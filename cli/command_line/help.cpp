#include "cli/command_line/help.h"

#include <CLI/CLI.hpp>
#include <string>

#include "cli/command_line/examples.h"

namespace zproof {
namespace {

/// "filters check"; empty for the root.
std::string path_of(const CLI::App& app) {
    if (app.get_parent() == nullptr) return "";
    const std::string above = path_of(*app.get_parent());
    return above + (above.empty() ? "" : " ") + app.get_name();
}

std::string help_of(const CLI::App* app, std::string name, CLI::AppFormatMode mode) {
    const CLI::Formatter usual;
    if (mode == CLI::AppFormatMode::Sub) return usual.make_expanded(app);
    const std::string shown = examples_in_words(path_of(*app));
    return usual.make_description(app) + (shown.empty() ? "" : "\n" + shown) + "\n" +
           usual.make_usage(app, std::move(name)) + usual.make_positionals(app) +
           usual.make_groups(app, mode) + usual.make_subcommands(app, mode) + usual.make_footer(app);
}

}  // namespace

void explain_by_example(CLI::App& root) { root.formatter_fn(help_of); }

}  // namespace zproof
