#include <algorithm>

#include "program/completion/scripts.h"
#include "program/completion/text.h"

namespace zproof {
namespace {

std::string zsh_quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

/// The text with its backslashes, brackets and colons escaped, as _arguments and _describe take it.
std::string plain(std::string text) {
    text = replaced(text, "\\", "\\\\");
    for (const char* special : {"[", "]", ":"}) text = replaced(text, special, std::string{"\\"} + special);
    return text;
}

/// "_zproof_filters_check" for "filters check".
std::string function_of(const OutlineCommand& command) {
    const std::string path = replaced(replaced(command.path, " ", "_"), "-", "_");
    return path.empty() ? "_zproof" : "_zproof_" + path;
}

/// The functions that offer values, each once.
class Offers {
  public:
    /// The name of the candidates' function, to be written where _arguments expects an action.
    std::string name_of(const Candidates& candidates) {
        if (candidates == Candidates{}) return " ";
        const auto at = std::ranges::find(known_, candidates);
        const std::string name = "_zproof_offer_" + std::to_string(at - known_.begin());
        if (at == known_.end()) known_.push_back(candidates);
        return name;
    }

    std::string text() const {
        std::string text;
        for (std::size_t i = 0; i < known_.size(); ++i)
            text += "_zproof_offer_" + std::to_string(i) + "() {\n" + body(known_[i]) + "}\n\n";
        return text;
    }

  private:
    static std::string body(const Candidates& candidates) {
        std::string text;
        if (!candidates.words.empty())
            text = std::string{"    "} +
                   (candidates.listing == Listing::by_comma ? "_values -s , word " : "compadd -- ") +
                   joined(candidates.words, " ") + "\n";
        if (candidates.paths == Paths::files) text += "    _files\n";
        if (candidates.paths == Paths::folders) text += "    _files -/\n";
        return text;
    }

    std::vector<Candidates> known_;
};

std::string option_line(const OutlineOption& option, Offers& offers) {
    const std::string others = "(" + joined(option.names, " ") + ")";
    std::string after = "[" + plain(option.description) + "]";
    if (option.takes != Takes::nothing)
        after += ":" + option.names.back() + ":" + offers.name_of(option.candidates);
    std::string text;
    for (const std::string& name : option.names)
        text += " \\\n        " +
                zsh_quoted(others + name + (option.takes != Takes::nothing && name.size() > 2 ? "=" : "") +
                           after);
    return text;
}

std::string positional_line(const OutlineOption& positional, Offers& offers) {
    return " \\\n        " + zsh_quoted((positional.takes == Takes::many ? "*:" : ":") + positional.names[0] +
                                        ":" + offers.name_of(positional.candidates));
}

/// A command with commands below it.
std::string group_tail(const OutlineCommand& command) {
    std::string text =
        " \\\n        '1: :->command' '*:: :->rest'\n    case $state in\n        command)\n"
        "            local -a commands=(";
    for (const OutlineCommand& below : command.commands)
        text += "\n                " + zsh_quoted(plain(below.name()) + ":" + below.description);
    text +=
        "\n            )\n            _describe command commands ;;\n        rest)\n"
        "            case $words[1] in\n";
    for (const OutlineCommand& below : command.commands)
        text += "                " + below.name() + ") " + function_of(below) + " ;;\n";
    return text + "            esac ;;\n    esac\n}\n\n";
}

std::string function_text(const OutlineCommand& command, Offers& offers) {
    std::string text = function_of(command) +
                       "() {\n    local curcontext=$curcontext state line\n    typeset -A opt_args\n"
                       "    _arguments -C";
    for (const OutlineOption& option : command.options) text += option_line(option, offers);
    for (const OutlineOption& positional : command.positionals) text += positional_line(positional, offers);
    return text + (command.commands.empty() ? "\n}\n\n" : group_tail(command));
}

}  // namespace

std::string zsh_completion(const OutlineCommand& root) {
    Offers offers;
    std::string functions;
    for_each_command(root,
                     [&](const OutlineCommand& command) { functions += function_text(command, offers); });
    return "#compdef zproof\n# zsh completion for zproof, made by: zproof completion zsh\n\n" + functions +
           offers.text() +
           "if [ \"$funcstack[1]\" = _zproof ]; then _zproof \"$@\"; else compdef _zproof zproof; fi\n";
}

}  // namespace zproof
