/// The run in a terminal.
#pragma once

#include <string>

#include "reports/results.h"

namespace zproof {

enum class Colour {
    plain,  ///< no escape sequences
    ansi,   ///< SGR colours; glyph and word say the same without them
};

/// A line per view, then each failure with its reason and the command that tells more, then the kinds of
/// notes and the totals. Ends in a newline. Control characters in names are shown escaped, so a scene cannot
/// write to the terminal.
std::string summary_table(const Results& results, Colour colour);

}  // namespace zproof
