#include "program/command_line/help.h"

#include <CLI/CLI.hpp>
#include <string>

#include "program/command_line/outline.h"

namespace zproof {

namespace {

/// The groups of options, with one empty line between them.
std::string groups_of(const CLI::App* app, CLI::AppFormatMode mode) {
    return CLI::detail::find_and_replace(CLI::Formatter{}.make_groups(app, mode), "\n\n\n", "\n\n");
}

std::string help_of(Examples examples, const CLI::App* app, std::string name, CLI::AppFormatMode mode) {
    const CLI::Formatter usual;
    if (mode == CLI::AppFormatMode::Sub) return usual.make_expanded(app);
    const std::string shown = in_words(examples, path_of(*app));
    return usual.make_description(app) + (shown.empty() ? "" : "\n" + shown) + "\n" +
           usual.make_usage(app, std::move(name)) + usual.make_positionals(app) + groups_of(app, mode) +
           usual.make_subcommands(app, mode) + usual.make_footer(app);
}

}  // namespace

void explain_by_example(CLI::App& root, Examples examples) {
    root.formatter_fn([examples](const CLI::App* app, std::string name, CLI::AppFormatMode mode) {
        return help_of(examples, app, std::move(name), mode);
    });
}

std::string in_words(Examples examples, std::string_view command) {
    constexpr std::size_t column = 40;
    std::string text;
    for (const Example& example : examples) {
        if (example.command != command) continue;
        std::string line = "  " + std::string{example.line};
        if (line.size() + 2 > column) line += "\n";
        const std::size_t used = line.back() == '\n' ? 0 : line.size();
        text += line + std::string(column - used, ' ') + std::string{example.meaning} + "\n";
    }
    return text;
}

}  // namespace zproof
