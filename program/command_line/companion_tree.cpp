#include "program/command_line/companion_tree.h"

#include <CLI/CLI.hpp>

#include "program/command_line/help.h"
#include "program/command_line/outline.h"
#include "program/command_line/parsing.h"
#include "program/companion.h"
#include "program/exit_code.h"
#include "program/version.h"

namespace zproof {

CompanionTree::CompanionTree(const std::string& command, Examples examples, ValueKinds kinds)
    : root_(std::make_unique<CLI::App>(companion_named(command)->purpose, "zproof " + command)),
      examples_(examples),
      kinds_(kinds) {
    explain_by_example(*root_, examples);
    root_->footer(exit_statuses_in_help);
    outline_ = root_->add_subcommand("outline", "what this program can parse, as JSON");
    root_->set_version_flag("--version", version_line);
    root_->require_subcommand(0, 1);
    outline_->group("");  // hidden
}

CompanionTree::~CompanionTree() = default;

std::optional<Command> CompanionTree::answer(int argc, const char* const* argv) {
    if (auto answered = answer_to(*root_, argc, argv)) return answered;
    if (!outline_->parsed()) return std::nullopt;
    return command_of(Answered{.common = {}, .text = json_of(outline_of(*root_, kinds_, examples_))},
                      "cannot answer");
}

}  // namespace zproof
