/// A command that was typed and understood, whatever its arguments are.
#pragma once

#include <any>
#include <functional>
#include <string>
#include <string_view>

#include "program/common_arguments.h"
#include "program/exit_code.h"

namespace CLI {
class App;
}

namespace zproof {

struct Command {
    std::any arguments;  ///< those of the command, by their type
    CommonArguments common;
    std::string_view refusal;  ///< what could not be done where `execute` throws: "cannot judge"
    std::function<ExitCode()> execute;
};

/// The command that execute(arguments) does.
template <class Arguments>
Command command_of(const Arguments& arguments, std::string_view refusal) {
    const auto common = [&] {
        if constexpr (requires { arguments.report.common; })
            return arguments.report.common;
        else
            return arguments.common;
    };
    return {arguments, common(), refusal, [arguments] { return execute(arguments); }};
}

/// Text that the command line asked for: --help, --version, a completion, the manual page.
struct Answered {
    CommonArguments common;
    std::string text;
};

/// Prints it.
ExitCode execute(const Answered& answered);

/// A command of the tree, and how its words become one once they are read. Throws UsageError where they mean
/// nothing.
struct Branch {
    CLI::App* app;
    std::function<Command()> understood;
};

}  // namespace zproof
