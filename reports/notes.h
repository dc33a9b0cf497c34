/// What the notes of all views say, in a terminal.
#pragma once

#include <string>

#include "reports/results.h"

namespace zproof {

/// A line for each kind of note, in order of appearance; a note's kind is what stands before its first ": ".
/// "note: room: images not read: 3", or where they differ among scenes, "note: 4 scenes: images not read".
std::string note_lines(const Results& results);

}  // namespace zproof
