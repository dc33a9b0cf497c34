/// The text of --help: what a command does, its examples, its usage and options.
#pragma once

namespace CLI {
class App;
}

namespace zproof {

/// From now on `root` and what is added below it explain themselves so.
void explain_by_example(CLI::App& root);

}  // namespace zproof
