/// Another program run to its end, or to its time limit.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace zproof::oracle {

/// What to run. The program sees the environment of this one, and nothing on its standard input.
struct Command {
    std::vector<std::string> arguments;  ///< the program first, by path or as found on PATH; at least one
    std::filesystem::path folder = ".";  ///< working directory; must exist
    std::chrono::milliseconds time_limit{std::chrono::minutes(5)};
    std::size_t kept_bytes = std::size_t{64} * 1024;  ///< of each output, the last ones
};

/// A line for /bin/sh, as the arguments of a command.
std::vector<std::string> shell_line(std::string line);

enum class Ending {
    exited,     ///< by itself; `code` is its exit status
    killed,     ///< by a signal, not ours; `code` is its number
    timed_out,  ///< ended by us; `code` is 0
};

/// What became of a command.
struct Outcome {
    Ending ending = Ending::exited;
    int code = 0;
    std::string output{}, error_output{};  ///< the end of standard output and of standard error

    bool succeeded() const { return ending == Ending::exited && code == 0; }
};

/// What became of a child that ended with this status, as waitpid() reports it; without its outputs.
Outcome outcome_of(int status);

/// Starts the command. It stands in a process group of its own, and whatever of that group is left when the
/// command has ended, when its time is up, when the result is dropped, or when this process is no more, is
/// killed; so a child that the command left behind neither lives on nor keeps us waiting. What has left the
/// group is killed as well (oracle/strays.h), unless this process is no more. Throws OracleError, naming
/// program and reason, where it cannot be started.
///
/// The result waits for its end, and is to be called once. Time is counted from the start. What the command
/// writes meanwhile stays in a pipe: one that writes much gets on only then.
std::function<Outcome()> start(const Command& command);

/// Starts it and waits for it.
Outcome run(const Command& command);

/// The last thousand characters of its standard error, or else of its standard output; for a message.
std::string last_output(const Outcome& outcome);

/// "exit status 1", "killed by signal 11 (Segmentation fault)", "stopped at its time limit of 300 s".
std::string in_words(const Outcome& outcome, std::chrono::milliseconds time_limit);

}  // namespace zproof::oracle
