/// The run in a terminal.
#pragma once

#include <optional>
#include <string>

#include "reports/results.h"

namespace zproof {

enum class Colour {
    plain,  ///< no escape sequences
    ansi,   ///< SGR colours; glyph and word say the same without them
};

/// How the summary is laid out.
struct SummaryStyle {
    Colour colour = Colour::plain;
    std::optional<std::size_t> width{};  ///< columns of the screen; nothing: as many as the table has
    enum class Rows {
        each_view,
        none,  ///< somebody has told of each view
    } rows = Rows::each_view;
};

/// A line per view, but for those that nobody began; then each failure with its reason and the command that
/// tells more, then the kinds of notes and the totals. Ends in a newline. Control characters in names are
/// shown escaped, so a scene cannot write to the terminal. Where the table is wider than the screen, it has
/// the columns alone that decide, and a line that says so.
std::string summary_table(const Results& results, const SummaryStyle& style);

}  // namespace zproof
