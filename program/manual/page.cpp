#include "program/manual/page.h"

#include <algorithm>
#include <sstream>

#include "program/completion/text.h"
#include "program/exit_code.h"
#include "program/version.h"

namespace zproof {
namespace {

/// Text that roff prints as it is: no escapes, no requests, hyphens as typed.
std::string literal(std::string text) {
    text = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    text = replaced(replaced(text, "\n.", "\n\\&."), "\n'", "\n\\&'");
    return text.starts_with('.') || text.starts_with('\'') ? "\\&" + text : text;
}

std::string bold(const std::string& text) { return "\\fB" + literal(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + literal(text) + "\\fR"; }

/// Text that is already in lines.
std::string as_typed(const std::string& text) {
    if (text.find_first_not_of(" \n") == std::string::npos) return "";
    const std::size_t first = text.find_first_not_of('\n'), last = text.find_last_not_of('\n');
    return ".PP\n.nf\n" + literal(text.substr(first, last + 1 - first)) + "\n.fi\n";
}

std::string sentence(std::string text) {
    if (!text.empty() && text.back() != '.') text += '.';
    return literal(text) + "\n";
}

/// " {auto|bar}", " TEXT" or nothing.
std::string value_of(const OutlineOption& option) {
    if (option.takes == Takes::nothing) return "";
    if (!option.choices.empty()) return " " + literal("{" + joined(option.choices, "|") + "}");
    return " " + italic(option.kind.substr(0, option.kind.find_first_of(" :")));
}

std::string term(const OutlineOption& option, const std::string& name) {
    std::string text = ".TP\n" + name + "\n" + sentence(option.description);
    if (!option.default_value.empty()) text += literal("Default: " + option.default_value + ".") + "\n";
    return text;
}

std::string usage_of(const OutlineCommand& command) {
    std::string text =
        bold("zproof" + (command.path.empty() ? "" : " " + command.path)) + " [" + italic("OPTION") + "]...";
    for (const OutlineOption& positional : command.positionals)
        text += " " + (positional.takes == Takes::many ? "[" + italic(positional.names[0]) + "]..."
                                                       : italic(positional.names[0]));
    return text + (command.commands.empty() ? "" : " " + italic("COMMAND")) + "\n";
}

std::string section_of(const OutlineCommand& command) {
    std::string text = ".SS " + literal("zproof " + command.path) + "\n" + usage_of(command) + ".PP\n" +
                       sentence(command.description) + as_typed(command.examples);
    for (const OutlineOption& positional : command.positionals)
        text += term(positional, italic(positional.names[0]));
    for (const OutlineOption& option : command.options) {
        if (option.names.back() == "--help") continue;  // said once, of all
        std::string names;
        for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + bold(name);
        text += term(option, names + value_of(option));
    }
    return text + as_typed(command.footer);
}

std::string exit_status() {
    std::string text = ".SH EXIT STATUS\n";
    for (const ExitStatus& row : exit_statuses())
        text += ".TP\n" + bold(std::to_string(int(row.code))) + "\n" + sentence(std::string{row.meaning});
    return text + ".PP\nThe status is never a count.\n";
}

constexpr const char* description = R"(.SH DESCRIPTION
zproof renders a scene with the rasterizer under test, asks independent references what every pixel should
hold, and decides every difference from the geometry itself, with error bounds derived from the arithmetic
that the renderer declares.
Each pixel is right, right within its bound, or a defect with its cause.
.PP
Results go to standard output, progress to standard error.
Every command explains itself with
.BR \-\-help .
)";

constexpr const char* closing = R"(.SH FILES
.TP
.I zproof\-out/
What a run leaves: report.html for people, results.json for programs, junit.xml for the CI server, and below
scenes/ the evidence of every view.
The folder appears whole or not at all, and replaces nothing that zproof has not made.
.SH ENVIRONMENT
.TP
.B NO_COLOR
No colours, unless they are asked for.
.SH SEE ALSO
.BR povray (1),
.BR ctest (1)
.PP
The documentation is installed below /usr/share/doc/zproof.
)";

}  // namespace

std::string manual_page(const OutlineCommand& root) {
    std::string text = ".\\\" Made by: zproof man\n.TH ZPROOF 1 \"\" \"zproof " + literal(version_number()) +
                       "\" \"User Commands\"\n.SH NAME\n" + literal("zproof") +
                       " \\- proves a z\\-buffer rasterizer right, pixel by pixel\n.SH SYNOPSIS\n" +
                       usage_of(root) + description + ".SH EXAMPLES\n" + as_typed(root.examples) +
                       ".SH COMMANDS\n";
    for (const OutlineCommand& command : leaves_of(root)) text += section_of(command);
    return text + exit_status() + closing;
}

}  // namespace zproof
