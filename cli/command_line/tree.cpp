#include "cli/command_line/tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/command_line/branches.h"
#include "cli/command_line/help.h"
#include "cli/filters/command_line.h"
#include "cli/study/command_line.h"
#include "cli/usage_error.h"
#include "cli/version.h"

namespace zproof {
namespace {

constexpr const char* statuses = R"(
Exit status: 0 proven, 1 a defect, 2 usage, 3 unreadable input, 4 nothing judged, 70 internal error,
130 interrupted.)";

}  // namespace

Branch add_filters(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand(
        "filters",
        "texture filters held to the exact area integral: run, list, table, figure, check, explain, crow");
    add_filters(app, words.filters);
    return {&app, [&words, &app] {
                return std::visit([](auto chosen) { return Command{std::move(chosen)}; },
                                  chosen_filters_command(app, words.filters));
            }};
}

Branch add_study(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("study", "the lessons as instruments: what each stage does");
    add_study(app, words.study);
    return {&app, [&words, &app] { return chosen_study(app, words.study); }};
}

CommandTree::CommandTree()
    : root_(std::make_unique<CLI::App>("Proves a z-buffer rasterizer right, pixel by pixel.", "zproof")) {
    explain_by_example(*root_);
    root_->footer(statuses);
    root_->set_version_flag("--version", version_line);
    root_->require_subcommand(0, 1);  // none is answered by chosen(), in words that name what is missing
    branches_ = {add_run(*root_, words_),          add_compare(*root_, words_),
                 add_explain(*root_, words_),      add_render(*root_, words_),
                 add_measure(*root_, words_),      add_fit(*root_, words_),
                 add_selfcheck(*root_, words_),    add_contract_check(*root_, words_),
                 add_selftest(*root_, words_),     add_plan(*root_, words_),
                 add_merge(*root_, words_),        add_report_again(*root_, words_),
                 add_diff_results(*root_, words_), add_waive(*root_, words_),
                 add_doctor(*root_, words_),       add_list(*root_, words_),
                 add_scenes(*root_, words_),       add_views(*root_, words_),
                 add_filters(*root_, words_),      add_study(*root_, words_),
                 add_completion(*root_, words_),   add_man(*root_, words_)};
}

CommandTree::~CommandTree() = default;

Command CommandTree::chosen() const {
    const auto branch = std::ranges::find_if(branches_, [](const Branch& b) { return b.app->parsed(); });
    if (branch != branches_.end()) return branch->understood();
    throw UsageError{"a command is expected, such as: zproof run (see: zproof --help)"};
}

}  // namespace zproof
