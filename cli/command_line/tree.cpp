#include "cli/command_line/tree.h"

#include <CLI/CLI.hpp>

#include "cli/command_line/branches.h"
#include "program/command_line/help.h"
#include "program/command_line/parsing.h"
#include "program/companion.h"
#include "program/version.h"

namespace zproof {
namespace {

/// It stands in the help; main() goes on as the companion before anything is parsed.
Branch add_companion(CLI::App& parent, const Companion& companion) {
    CLI::App& app = *parent.add_subcommand(companion.command, companion.purpose);
    return {&app, [&companion]() -> Command { become(companion, {}); }};
}

}  // namespace

CommandTree::CommandTree()
    : root_(std::make_unique<CLI::App>("Proves a z-buffer rasterizer right, pixel by pixel.", "zproof")) {
    explain_by_example(*root_, examples());
    root_->footer(exit_statuses_in_help);
    root_->set_version_flag("--version", version_line);
    root_->require_subcommand(0, 1);  // none is answered by chosen(), in words that name what is missing
    branches_ = {add_run(*root_, words_),
                 add_compare(*root_, words_),
                 add_explain(*root_, words_),
                 add_render(*root_, words_),
                 add_measure(*root_, words_),
                 add_fit(*root_, words_),
                 add_selfcheck(*root_, words_),
                 add_conformance(*root_, words_),
                 add_contract_check(*root_, words_),
                 add_selftest(*root_, words_),
                 add_plan(*root_, words_),
                 add_merge(*root_, words_),
                 add_report_again(*root_, words_),
                 add_diff_results(*root_, words_),
                 add_waive(*root_, words_),
                 add_doctor(*root_, words_),
                 add_list(*root_, words_),
                 add_scenes(*root_, words_),
                 add_views(*root_, words_),
                 add_init(*root_, words_),
                 add_companion(*root_, companions()[0]),
                 add_companion(*root_, companions()[1]),
                 add_completion(*root_, words_),
                 add_man(*root_, words_)};
}

CommandTree::~CommandTree() = default;

Command CommandTree::chosen() const { return zproof::chosen(branches_, "zproof run"); }

OutlineCommand whole_outline(const CLI::App& root) {
    OutlineCommand outline = outline_of(root, value_kinds(), examples());
    for (OutlineCommand& command : outline.commands)
        if (const Companion* companion = companion_named(command.path)) command = outline_of(*companion);
    return outline;
}

}  // namespace zproof
