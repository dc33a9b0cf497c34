#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <thread>

#include "cli/command_line/misspelling.h"
#include "cli/command_line/tree.h"
#include "cli/usage_error.h"

namespace zproof {
namespace {

std::string as_typed(int argc, const char* const* argv) {
    std::string line = "zproof";
    for (int i = 1; i < argc; ++i) line += " " + shell_quoted(argv[i]);
    return line;
}

/// CLI11 throws both for mistakes and for --help; only the former are errors of the user.
Answered answer_or_throw(const CLI::App& app, const CLI::ParseError& e) {
    if (e.get_exit_code() != 0) throw UsageError{e.what() + misspelling_in(app) + " (see: zproof --help)"};
    std::ostringstream text;
    app.exit(e, text, text);
    return {text.str()};
}

}  // namespace

int available_threads() { return std::clamp(int(std::thread::hardware_concurrency()), 1, 1024); }

Command parse_command_line(int argc, const char* const* argv) {
    CommandTree tree;
    CommandWords& words = tree.words();
    words.run.report.typed = words.compare.report.typed = words.filters.run.typed = words.study.typed =
        as_typed(argc, argv);
    try {
        tree.root().parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return answer_or_throw(tree.root(), e);
    }
    return tree.chosen();
}

std::string shell_quoted(const std::string& word) {
    constexpr const char* harmless =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=:,+@%";
    if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return quoted + "'";
}

}  // namespace zproof
