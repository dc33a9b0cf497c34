#include "program/command_line/outline.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace zproof {

namespace {

/// The words of "TEXT:{always,auto,never}"; none where it is another kind.
std::vector<std::string> choices_in(const std::string& kind) {
    const std::size_t open = kind.find(":{");
    if (open == std::string::npos || kind.back() != '}') return {};
    std::istringstream in{kind.substr(open + 2, kind.size() - open - 3)};
    std::vector<std::string> words;
    for (std::string word; std::getline(in, word, ',');) words.push_back(word);
    return words;
}

Takes takes_of(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0) return Takes::nothing;
    return option.get_expected_max() > 1 && option.get_allow_extra_args() ? Takes::many : Takes::one;
}

std::vector<std::string> names_of(const CLI::Option& option) {
    if (!option.nonpositional()) return {option.get_name(true)};
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

Candidates candidates_for(const OutlineOption& option, const std::string& path, ValueKinds kinds) {
    if (!option.choices.empty()) return {option.choices};
    for (const ValueKind& kind : kinds)
        if (kind.name == option.kind || kind.name == option.names.front()) return kind.candidates(path);
    const std::string kind = option.kind.substr(0, option.kind.find(':'));  // of "FOLDER:DIR"
    if (kind == "FOLDER") return {{}, Paths::folders};
    return {{}, kind == "TEXT" || kind == "FILE" ? Paths::files : Paths::none};
}

OutlineOption option_of(const CLI::Option& option, const std::string& path, ValueKinds kinds) {
    const std::string kind = option.get_type_name();
    OutlineOption outline{.names = names_of(option),
                          .takes = takes_of(option),
                          .choices = choices_in(kind),
                          .kind = takes_of(option) == Takes::nothing ? "" : kind,
                          .description = option.get_description(),
                          .default_value = option.get_default_str(),
                          .candidates = {}};
    if (outline.takes != Takes::nothing) outline.candidates = candidates_for(outline, path, kinds);
    return outline;
}

}  // namespace

std::string OutlineCommand::name() const { return path.substr(path.rfind(' ') + 1); }

std::string path_of(const CLI::App& app) {
    if (app.get_parent() == nullptr)
        return app.get_name().substr(std::min(app.get_name().size(), std::string{"zproof "}.size()));
    const std::string above = path_of(*app.get_parent());
    return above + (above.empty() ? "" : " ") + app.get_name();
}

OutlineCommand outline_of(const CLI::App& app, ValueKinds kinds, Examples examples) {
    OutlineCommand command{.path = path_of(app),
                           .description = app.get_description(),
                           .examples = in_words(examples, path_of(app)),
                           .footer = app.get_footer(),
                           .options = {},
                           .positionals = {},
                           .commands = {}};
    for (const CLI::Option* option : app.get_options())
        (option->nonpositional() ? command.options : command.positionals)
            .push_back(option_of(*option, command.path, kinds));
    for (const CLI::App* below : app.get_subcommands(std::function<bool(const CLI::App*)>{}))
        if (!below->get_group().empty()) command.commands.push_back(outline_of(*below, kinds, examples));
    return command;
}

std::vector<OutlineCommand> leaves_of(const OutlineCommand& root) {
    if (root.commands.empty()) return {root};
    std::vector<OutlineCommand> leaves;
    for (const OutlineCommand& command : root.commands)
        std::ranges::copy(leaves_of(command), std::back_inserter(leaves));
    return leaves;
}

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Candidates, words, paths, listing)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OutlineOption, names, takes, choices, kind, description, default_value,
                                   candidates)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OutlineCommand, path, description, examples, footer, options, positionals,
                                   commands)

std::string json_of(const OutlineCommand& outline) { return Json(outline).dump() + "\n"; }

OutlineCommand outline_from(const std::string& json) {
    try {
        return Json::parse(json).get<OutlineCommand>();
    } catch (const Json::exception& e) {
        throw std::runtime_error{std::string{"no outline of a command line: "} + e.what()};
    }
}

}  // namespace zproof
