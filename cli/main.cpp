#include <span>

#include "cli/commands.h"
#include "program/companion.h"
#include "program/run_program.h"

namespace zproof {
namespace {

/// The words of a companion's command are its own to understand.
Command understood(int argc, const char* const* argv, const Environment& environment) {
    const std::span<const char* const> words{argv, std::size_t(argc)};
    const Companion* companion = argc > 1 ? companion_named(argv[1]) : nullptr;
    if (companion == nullptr) return parse_command_line(argc, argv, environment);
    return {{}, {}, "cannot start the program", [companion, words]() -> ExitCode {
                become(*companion, words.subspan(2));
            }};
}

}  // namespace
}  // namespace zproof

int main(int argc, char** argv) { return zproof::run_program(argc, argv, zproof::understood); }
