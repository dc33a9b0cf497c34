#include "program/companion.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "oracle/subprocess.h"
#include "program/command_line/outline.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

constexpr std::array all{
    Companion{
        "filters",
        "texture filters held to the exact area integral: run, list, table, figure, check, explain, normals, "
        "crow"},
    Companion{"study", "the lessons as instruments: what each stage does"}};

fs::path required(const Companion& companion) {
    const auto program = program_of(companion);
    const std::string name = companion.command;
    if (!program)
        throw std::runtime_error{
            "zproof-" + name +
            " is not beside zproof; install it with zproof's package, or build it: ./dev " + name};
    return *program;
}

template <class Words>
std::vector<std::string> line_of(const fs::path& program, const Words& words) {
    std::vector<std::string> line{program.string()};
    line.insert(line.end(), words.begin(), words.end());
    return line;
}

std::vector<char*> argv_of(const std::vector<std::string>& words) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    return argv;
}

[[noreturn]] void refuse(const fs::path& program, int error) {
    throw std::runtime_error{program.string() + ": " + std::generic_category().message(error)};
}

}  // namespace

std::span<const Companion> companions() { return all; }

const Companion* companion_named(const std::string& command) {
    const auto found = std::ranges::find(all, command, &Companion::command);
    return found == all.end() ? nullptr : &*found;
}

std::optional<fs::path> program_of(const Companion& companion) {
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    const fs::path program = self.parent_path() / ("zproof-" + std::string{companion.command});
    return !error && access(program.c_str(), X_OK) == 0 ? std::optional{program} : std::nullopt;
}

void become(const Companion& companion, std::span<const char* const> words) {
    const fs::path program = required(companion);
    const std::vector<std::string> line = line_of(program, words);
    execv(program.c_str(), argv_of(line).data());
    refuse(program, errno);
}

int status_of(const Companion& companion, const std::vector<std::string>& words) {
    const fs::path program = required(companion);
    const std::vector<std::string> line = line_of(program, words);
    pid_t child = 0;
    if (const int error =
            posix_spawn(&child, program.c_str(), nullptr, nullptr, argv_of(line).data(), environ))
        refuse(program, error);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) refuse(program, errno);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

OutlineCommand outline_of(const Companion& companion) {
    OutlineCommand alone;
    alone.path = companion.command;
    alone.description = companion.purpose;
    const auto program = program_of(companion);
    if (!program) return alone;
    oracle::Command asked{.arguments = {program->string(), "outline"}};
    asked.kept_bytes = std::size_t{1} << 24;
    const oracle::Outcome outcome = oracle::run(asked);
    if (!outcome.succeeded())
        throw std::runtime_error{program->string() + ": " + oracle::in_words(outcome, asked.time_limit)};
    return outline_from(outcome.output);
}

}  // namespace zproof
