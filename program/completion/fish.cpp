#include "program/completion/scripts.h"
#include "program/completion/text.h"

namespace zproof {
namespace {

constexpr const char* head = R"(# fish completion for zproof, made by: zproof completion fish
function __zproof_command --description 'the command that is being typed'
    set -l tokens (commandline -opc)
    set -l command $tokens[2]
    if contains -- "$command" $argv; and test (count $tokens) -gt 2
        set command "$command $tokens[3]"
    end
    echo $command
end

function __zproof_list --description 'words, after those that stand before a comma'
    set -l before (string match -r '.*,' -- (commandline -ct))
    printf '%s\n' "$before"$argv
end

complete -c zproof -f
)";

std::string quoted(const std::string& text) {
    return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

/// What follows a `complete` that takes a value.
std::string values(const Candidates& candidates) {
    if (candidates.paths == Paths::folders) return " -xa '(__fish_complete_directories)'";
    const std::string words = joined(candidates.words, " ");
    if (candidates.listing == Listing::by_comma) return " -xa '(__zproof_list " + words + ")'";
    const std::string how = candidates.paths == Paths::files ? " -rF" : " -x";
    return how + (words.empty() ? "" : " -a " + quoted(words));
}

std::string option_line(const OutlineOption& option) {
    std::string text;
    for (const std::string& name : option.names)
        text += name.size() == 2 ? " -s " + name.substr(1) : " -l " + name.substr(2);
    if (option.takes != Takes::nothing) text += values(option.candidates);
    return text + " -d " + quoted(option.description) + "\n";
}

std::string lines_of(const OutlineCommand& command, const std::string& groups) {
    const std::string start =
        "complete -c zproof -n " + quoted("test (__zproof_command " + groups + ") = " + quoted(command.path));
    std::string text;
    for (const OutlineCommand& below : command.commands)
        text += start + " -a " + below.name() + " -d " + quoted(below.description) + "\n";
    for (const OutlineOption& option : command.options) text += start + option_line(option);
    for (const OutlineOption& positional : command.positionals) {
        const Candidates candidates = positional.candidates;
        if (candidates != Candidates{}) text += start + values(candidates) + "\n";
    }
    return text;
}

}  // namespace

std::string fish_completion(const OutlineCommand& root) {
    std::vector<std::string> groups;
    for (const OutlineCommand& command : root.commands)
        if (!command.commands.empty()) groups.push_back(command.name());
    std::string text = head;
    for_each_command(root,
                     [&](const OutlineCommand& command) { text += lines_of(command, joined(groups, " ")); });
    return text;
}

}  // namespace zproof
