/// main() of every program of zproof's.
#pragma once

#include "program/command.h"
#include "program/settings/sources.h"

namespace zproof {

using ParseCommandLine = Command (*)(int argc, const char* const* argv, const Environment& environment);

/// Understands the words and does what they ask. Its status is the program's.
int run_program(int argc, const char* const* argv, ParseCommandLine parse);

}  // namespace zproof
