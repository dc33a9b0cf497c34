#include <utility>

#include "program/completion/scripts.h"
#include "program/completion/text.h"

namespace zproof {
namespace {

/// What is the same for any tree. `takes` is an option whose value is being typed; `place` counts
/// positionals.
constexpr const char* engine = R"(
_zproof() {
    local command= cur=${COMP_WORDS[COMP_CWORD]} takes= words= paths= list= options= commands=
    local i word start=1 place=1 prefix=
    COMPREPLY=()
    if [ "$COMP_CWORD" -gt 1 ]; then command=${COMP_WORDS[1]} start=2; fi
    if [ "$COMP_CWORD" -gt 2 ] && _zproof_is_group "$command"; then
        command="$command ${COMP_WORDS[2]}" start=3
    fi
    _zproof_command "$command" || return 0
    for ((i = start; i < COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        if [ "$word" = "=" ]; then continue; fi
        if [ -n "$takes" ]; then
            takes=
        elif _zproof_value "$command/$word"; then
            takes=$word
        elif [ "${word#-}" = "$word" ]; then
            place=$((place + 1))
        fi
    done
    if [ "$cur" = "=" ]; then cur=; fi
    words= paths= list=
    if [ -n "$takes" ]; then
        _zproof_value "$command/$takes"
    elif [ "${cur#-}" != "$cur" ]; then
        words=$options
    elif [ -n "$commands" ]; then
        words=$commands
    else
        _zproof_value "$command/#$place" || _zproof_value "$command/#*"
    fi
    if [ -n "$list" ] && [ "${cur#*,}" != "$cur" ]; then prefix=${cur%,*}, cur=${cur##*,}; fi
    local IFS=$'\n'
    COMPREPLY=($(compgen -P "$prefix" -W "${words// /$'\n'}" -- "$cur"))
    case $paths in
        files) COMPREPLY+=($(compgen -f -- "$cur")) ;;
        folders) COMPREPLY+=($(compgen -d -- "$cur")) ;;
    esac
    if [ -n "$paths" ]; then compopt -o filenames 2>/dev/null; fi
    return 0
}
complete -F _zproof zproof
)";

std::string in_double_quotes(const std::string& text) { return "\"" + text + "\""; }

/// The arms of _zproof_value: for each set of candidates, all places at which it is offered.
class ValueArms {
  public:
    void add(const OutlineCommand& command) {
        for (const OutlineOption& option : command.options)
            if (option.takes != Takes::nothing)
                for (const std::string& name : option.names)
                    add(command.path + "/" + name, option.candidates);
        int place = 0;
        for (const OutlineOption& positional : command.positionals) {
            ++place;
            add(command.path + "/#" + (positional.takes == Takes::many ? "*" : std::to_string(place)),
                positional.candidates);
        }
    }

    std::string text() const {
        std::string text;
        for (const auto& [candidates, keys] : arms_)
            text += "        " + joined(keys, " | \\\n        ") + ")\n            words=\"" +
                    joined(candidates.words, " ") + "\"" + paths_of(candidates) +
                    (candidates.listing == Listing::by_comma ? " list=1" : "") + " ;;\n";
        return text;
    }

  private:
    void add(const std::string& key, const Candidates& candidates) {
        for (auto& [known, keys] : arms_)
            if (known == candidates) return keys.push_back(in_double_quotes(key));
        arms_.push_back({candidates, {in_double_quotes(key)}});
    }

    static std::string paths_of(const Candidates& candidates) {
        if (candidates.paths == Paths::none) return "";
        return candidates.paths == Paths::files ? " paths=files" : " paths=folders";
    }

    std::vector<std::pair<Candidates, std::vector<std::string>>> arms_;
};

std::string command_arm(const OutlineCommand& command) {
    std::vector<std::string> options, names;
    for (const OutlineOption& option : command.options)
        options.insert(options.end(), option.names.begin(), option.names.end());
    for (const OutlineCommand& below : command.commands) names.push_back(below.name());
    return "        " + in_double_quotes(command.path) +
           ") options=" + in_double_quotes(joined(options, " ")) +
           " commands=" + in_double_quotes(joined(names, " ")) + " ;;\n";
}

}  // namespace

std::string bash_completion(const OutlineCommand& root) {
    std::string commands;
    ValueArms values;
    std::vector<std::string> groups;
    for_each_command(root, [&](const OutlineCommand& command) {
        commands += command_arm(command);
        values.add(command);
        if (!command.path.empty() && !command.commands.empty())
            groups.push_back(in_double_quotes(command.path));
    });
    return "# bash completion for zproof, made by: zproof completion bash\n"
           "_zproof_is_group() {\n    case $1 in\n        " +
           joined(groups, " | ") + ") return 0 ;;\n    esac\n    return 1\n}\n\n" +
           "_zproof_command() {\n    case $1 in\n" + commands + "        *) return 1 ;;\n    esac\n}\n\n" +
           "# COMMAND/OPTION or COMMAND/#PLACE: what may be typed there; false where nothing is\n"
           "_zproof_value() {\n    words= paths= list=\n    case $1 in\n" +
           values.text() + "        *) return 1 ;;\n    esac\n}\n" + engine;
}

}  // namespace zproof
