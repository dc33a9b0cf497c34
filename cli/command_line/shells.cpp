// The commands that write what a shell and man(1) want to know of zproof.
#include "cli/command_line/branches.h"
#include "cli/command_line/options.h"
#include "cli/command_line/outline.h"
#include "cli/completion/scripts.h"
#include "cli/manual/page.h"

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
                words.completion.text = writers.at(words.shell)(outline_of(parent));
                return words.completion;
            }};
}

Branch add_man(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("man", "the manual page, in roff");
    add_common(app, words.manual.common);
    return {&app, [&] {
                words.manual.text = manual_page(outline_of(parent));
                return words.manual;
            }};
}

}  // namespace zproof
