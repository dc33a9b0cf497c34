/// The text of --help: what a command does, its examples, its usage and options.
#pragma once

#include "program/command_line/examples.h"

namespace CLI {
class App;
}

namespace zproof {

/// Makes `root` and everything added below it later show examples in their help.
void explain_by_example(CLI::App& root, Examples examples);

}  // namespace zproof
