// The commands that write what a shell and man(1) want to know of zproof.
#include "cli/command_line/branches.h"
#include "cli/command_line/options.h"
#include "cli/command_line/tree.h"
#include "cli/commands.h"
#include "program/command_line/outline.h"
#include "program/completion/scripts.h"
#include "program/manual/page.h"

namespace zproof {
namespace {

const std::map<std::string, std::string (*)(const OutlineCommand&)> writers{
    {"bash", bash_completion}, {"fish", fish_completion}, {"zsh", zsh_completion}};

}  // namespace

Branch add_completion(CLI::App& parent, CommandWords& words) {
    CLI::App& app =
        *parent.add_subcommand("completion", "completion of commands, options and names for a shell");
    app.add_option("SHELL", words.shell, "which shell's")
        ->required()
        ->check(CLI::IsMember({"bash", "fish", "zsh"}));
    add_common(app, words.completion.common);
    return {&app, [&] {
                words.completion.text = writers.at(words.shell)(whole_outline(parent));
                return command_of(words.completion, "cannot answer");
            }};
}

Branch add_man(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("man", "the manual page, in roff");
    add_common(app, words.manual.common);
    return {&app, [&] {
                words.manual.text = manual_page(whole_outline(parent));
                return command_of(words.manual, "cannot answer");
            }};
}

}  // namespace zproof
