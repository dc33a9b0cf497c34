#include "oracle/subprocess.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>
extern "C" {
#include <sys/pidfd.h>  // glibc 2.36 forgets to say that it is C
}

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "oracle/file_descriptor.h"
#include "oracle/oracle_error.h"
#include "oracle/strays.h"

namespace zproof::oracle {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void refuse(const Command& command, int reason) {
    throw OracleError(command.arguments.at(0) + ": cannot be started in " + command.folder.string() + ": " +
                      std::strerror(reason));
}

void require(int result, const Command& command) {
    if (result != 0) refuse(command, result);
}

Pipe pipe_for(const Command& command) {
    Pipe pipe = open_pipe();
    require(pipe.from.is_open() ? 0 : errno, command);
    return pipe;
}

/// One of the command's outputs: its end that we read, and what has come of it.
struct OutputPipe {
    FileDescriptor ours, theirs;
    std::size_t kept_bytes;
    std::string text;

    explicit OutputPipe(const Command& command) : kept_bytes(command.kept_bytes) {
        Pipe pipe = pipe_for(command);
        ours = std::move(pipe.from);
        theirs = std::move(pipe.to);
        fcntl(ours.number(), F_SETFL, O_NONBLOCK);
    }

    /// Takes what is there, though not more than a pipe holds at a time: a program may write without end.
    /// Closes at the end of the output.
    void drain() {
        std::array<char, 16384> piece;
        for (int pieces = 0; pieces < 64 && ours.is_open(); ++pieces) {
            const ssize_t count = ::read(ours.number(), piece.data(), piece.size());
            if (count > 0) {
                keep(piece.data(), std::size_t(count));
            } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
                ours.close();
            } else if (errno == EAGAIN) {
                return;
            }
        }
    }

  private:
    void keep(const char* piece, std::size_t count) {
        text.append(piece, count);
        if (text.size() > kept_bytes) text.erase(0, text.size() - kept_bytes);
    }
};

/// What a program is started with.
struct SpawnArguments {
    std::vector<std::string> arguments;
    std::filesystem::path folder;
    int input, output, error_output;  ///< files that it gets as 0, 1 and 2
    pid_t group;                      ///< the process group that it joins; 0: it leads one of its own
    std::string mark{};               ///< an entry that its environment gets; empty: none
};

/// posix_spawn's two arguments that C must free.
class SpawnPlan {
  public:
    SpawnPlan(const SpawnArguments& start, const Command& command) {
        require(posix_spawn_file_actions_init(&actions_), command);
        require(posix_spawnattr_init(&attributes_), command);
        require(posix_spawn_file_actions_adddup2(&actions_, start.input, 0), command);
        require(posix_spawn_file_actions_adddup2(&actions_, start.output, 1), command);
        require(posix_spawn_file_actions_adddup2(&actions_, start.error_output, 2), command);
        require(posix_spawn_file_actions_addchdir_np(&actions_, start.folder.c_str()), command);
        set_signals_and_group(start.group);
    }
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    pid_t carry_out(SpawnArguments start, const Command& command) const {
        std::vector<char*> arguments, environment;
        for (std::string& argument : start.arguments) arguments.push_back(argument.data());
        arguments.push_back(nullptr);
        for (char** entry = environ; *entry != nullptr; ++entry) environment.push_back(*entry);
        if (!start.mark.empty()) environment.push_back(start.mark.data());
        environment.push_back(nullptr);
        pid_t child = 0;
        require(posix_spawnp(&child, arguments.at(0), &actions_, &attributes_, arguments.data(),
                             environment.data()),
                command);
        return child;
    }

  private:
    /// No signal blocked, those that a parent may have set aside as they were.
    void set_signals_and_group(pid_t group) {
        sigset_t none, as_usual;
        sigemptyset(&none);
        sigemptyset(&as_usual);
        for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGCHLD}) sigaddset(&as_usual, signal);
        posix_spawnattr_setflags(&attributes_,
                                 POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
        posix_spawnattr_setpgroup(&attributes_, group);
        posix_spawnattr_setsigmask(&attributes_, &none);
        posix_spawnattr_setsigdefault(&attributes_, &as_usual);
    }

    posix_spawn_file_actions_t actions_;
    posix_spawnattr_t attributes_;
};

pid_t spawned(const SpawnArguments& start, const Command& command) {
    return SpawnPlan(start, command).carry_out(start, command);
}

/// Leads a command's process group, and kills that group as soon as we are no more, whichever way we went: it
/// waits for the end of a pipe whose other end nobody but this process holds. Not even SIGKILL, or a second
/// Ctrl-C, leaves a command running.
class GroupLeader {
  public:
    GroupLeader(const Command& command, const FileDescriptor& dev_null) {
        Pipe pipe = pipe_for(command);
        ours_ = std::move(pipe.to);
        id_ = spawned({.arguments = {"/bin/sh", "-c", "read nothing; kill -9 0"},
                       .folder = "/",
                       .input = pipe.from.number(),
                       .output = dev_null.number(),
                       .error_output = dev_null.number(),
                       .group = 0},
                      command);
    }
    ~GroupLeader() { end_group(); }
    GroupLeader(const GroupLeader&) = delete;
    GroupLeader& operator=(const GroupLeader&) = delete;

    pid_t group() const { return id_; }

    /// The number of the group is nobody else's until its leader is reaped.
    void end_group() {
        if (id_ == 0) return;
        ::kill(-id_, SIGKILL);
        status_at_end(std::exchange(id_, 0));
    }

  private:
    FileDescriptor ours_;
    pid_t id_ = 0;
};

/// A started command. Nothing that it has started outlives this object.
class Child {
  public:
    Child(const Command& command, const OutputPipe& output, const OutputPipe& error_output)
        : dev_null_(open("/dev/null", O_RDWR | O_CLOEXEC)),
          group_leader_(command, dev_null_),
          id_(spawned({.arguments = command.arguments,
                       .folder = command.folder,
                       .input = dev_null_.number(),
                       .output = output.theirs.number(),
                       .error_output = error_output.theirs.number(),
                       .group = group_leader_.group(),
                       .mark = mark_},
                      command)),
          watched_(pidfd_open(id_, 0)) {
        if (watched_.is_open()) return;
        const int reason = errno;
        end();
        refuse(command, reason);
    }
    ~Child() { end(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Readable once the command has ended.
    int watched() const { return watched_.number(); }

    /// Kills the group and what has left it, then reaps. The status as waitpid reports it; nothing the second
    /// time.
    std::optional<int> end() {
        if (id_ == 0) return std::nullopt;
        group_leader_.end_group();
        const int status = status_at_end(std::exchange(id_, 0));
        end_strays(mark_);
        return status;
    }

  private:
    FileDescriptor dev_null_;
    GroupLeader group_leader_;
    std::string mark_ = next_command_mark();
    pid_t id_;
    FileDescriptor watched_;
};

int milliseconds_until(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    return int(std::clamp<decltype(left)>(left, 0, 3'600'000));
}

enum class WaitResult { ended, timed_out };

/// Drains the outputs until the command has ended or its time is up.
WaitResult wait_for(const Child& child, OutputPipe& output, OutputPipe& error_output,
                    Clock::time_point deadline) {
    for (;;) {
        std::array<pollfd, 3> watched{{{child.watched(), POLLIN, 0},
                                       {output.ours.number(), POLLIN, 0},
                                       {error_output.ours.number(), POLLIN, 0}}};
        poll(watched.data(), watched.size(), milliseconds_until(deadline));
        output.drain();
        error_output.drain();
        if (watched[0].revents != 0) return WaitResult::ended;
        if (Clock::now() >= deadline) return WaitResult::timed_out;
    }
}

/// A command, from its start to its end.
class Running {
  public:
    explicit Running(const Command& command)
        : deadline_(Clock::now() + command.time_limit),
          output_(command),
          error_output_(command),
          child_(command, output_, error_output_) {
        output_.theirs.close();
        error_output_.theirs.close();
    }

    Outcome wait() {
        const WaitResult wait_result = wait_for(child_, output_, error_output_, deadline_);
        const int status = child_.end().value();
        output_.drain();
        error_output_.drain();
        Outcome outcome =
            wait_result == WaitResult::timed_out ? Outcome{.ending = Ending::timed_out} : outcome_of(status);
        outcome.output = std::move(output_.text);
        outcome.error_output = std::move(error_output_.text);
        return outcome;
    }

  private:
    Clock::time_point deadline_;
    OutputPipe output_, error_output_;
    Child child_;
};

}  // namespace

Outcome outcome_of(int status) {
    if (WIFSIGNALED(status)) return {.ending = Ending::killed, .code = WTERMSIG(status)};
    return {.ending = Ending::exited, .code = WEXITSTATUS(status)};
}

std::vector<std::string> shell_line(std::string line) { return {"/bin/sh", "-c", std::move(line)}; }

std::function<Outcome()> start(const Command& command) {
    return [running = std::make_shared<Running>(command)] { return running->wait(); };
}

Outcome run(const Command& command) { return Running(command).wait(); }

std::string last_output(const Outcome& outcome) {
    constexpr std::size_t most = 1000;
    const std::string& said = outcome.error_output.empty() ? outcome.output : outcome.error_output;
    return said.size() <= most ? said : "... " + said.substr(said.size() - most);
}

std::string in_words(const Outcome& outcome, std::chrono::milliseconds time_limit) {
    switch (outcome.ending) {
        case Ending::exited:
            return "exit status " + std::to_string(outcome.code);
        case Ending::killed:
            return "killed by signal " + std::to_string(outcome.code) + " (" + strsignal(outcome.code) + ")";
        case Ending::timed_out:
            break;
    }
    const std::string seconds = std::to_string(double(time_limit.count()) / 1000);
    return "stopped at its time limit of " + seconds.substr(0, seconds.find('.') + 2) + " s";
}

}  // namespace zproof::oracle
