#include "oracle/isolated.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>
#include <span>
#include <utility>

#include "frame/frame_error.h"
#include "oracle/file_descriptor.h"

namespace zproof::oracle {
namespace {

using Clock = std::chrono::steady_clock;

/// What the copy sends first. An answer that is shorter than this says was cut by an end of the copy.
struct Answer {
    enum class Kind : std::uint64_t { result, refusal, failure } kind;
    std::uint64_t size;
};

/// What all that was sent begins with; nothing where it is not as long as it says.
std::optional<Answer> whole_answer(const Bytes& sent) {
    Answer answer{};
    if (sent.size() < sizeof answer) return {};
    std::memcpy(&answer, sent.data(), sizeof answer);
    if (sent.size() - sizeof answer != answer.size) return {};
    return answer;
}

void limit_memory(std::size_t more_bytes) {
    const rlim_t most = address_space_bytes() + more_bytes;
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = std::min(limit.rlim_max, most);
    setrlimit(RLIMIT_AS, &limit);
    const rlimit no_core{};
    setrlimit(RLIMIT_CORE, &no_core);
}

/// Its memory is limited and its words go nowhere: libraries complain on standard error as they crash. What
/// interrupts is for its parent alone, which it does not outlive.
void set_apart(std::size_t memory_bytes) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_IGN);
    for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    limit_memory(memory_bytes);
}

void send(int to, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(to, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) return;
        bytes = bytes.subspan(std::size_t(std::max<ssize_t>(count, 0)));
    }
}

void send(int to, Answer::Kind kind, std::span<const std::byte> bytes) {
    const Answer answer{kind, bytes.size()};
    send(to, std::as_bytes(std::span{&answer, 1}));
    send(to, bytes);
}

void send_words(int to, Answer::Kind kind, const std::string& words) {
    send(to, kind, std::as_bytes(std::span{words}));
}

[[noreturn]] void do_in_copy(int to, const IsolationLimits& limits, const std::function<Bytes()>& work) {
    set_apart(limits.memory_bytes);
    try {
        send(to, Answer::Kind::result, work());
    } catch (const FrameError& e) {
        send_words(to, Answer::Kind::refusal, e.what());
    } catch (const std::bad_alloc&) {
        send_words(
            to, Answer::Kind::failure,
            "more memory is needed than is allowed, " + std::to_string(limits.memory_bytes >> 20) + " MiB");
    } catch (const std::exception& e) {
        send_words(to, Answer::Kind::failure, e.what());
    }
    _exit(0);
}

/// The copy, which does not outlive this object.
class Copy {
  public:
    Copy(const std::string& name, const IsolationLimits& limits, const std::function<Bytes()>& work) {
        Pipe pipe = open_pipe();
        if (!pipe.from.is_open()) refuse(name);
        from_ = std::move(pipe.from);
        id_ = fork();
        if (id_ < 0) refuse(name);
        if (id_ == 0) do_in_copy(pipe.to.number(), limits, work);
    }
    ~Copy() { end(); }
    Copy(const Copy&) = delete;
    Copy& operator=(const Copy&) = delete;

    /// All that it sends until that is whole, or it ends. False where its time is up.
    bool take(Bytes& all, Clock::time_point deadline) const {
        constexpr std::size_t piece = std::size_t{1} << 20;
        for (std::size_t size = 0;;) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
            pollfd watched{from_.number(), POLLIN, 0};
            if (left <= 0) return false;
            if (poll(&watched, 1, int(std::min<decltype(left)>(left, 3'600'000))) <= 0) continue;
            all.resize(size + piece);
            const ssize_t count = ::read(from_.number(), all.data() + size, piece);
            size += std::size_t(std::max<ssize_t>(count, 0));
            all.resize(size);
            if (count == 0 || (count < 0 && errno != EINTR) || whole_answer(all)) return true;
        }
    }

    /// Its status as waitpid reports it; kills it where it still runs.
    int end() {
        if (id_ == 0) return status_;
        ::kill(id_, SIGKILL);
        status_ = status_at_end(std::exchange(id_, 0));
        return status_;
    }

  private:
    [[noreturn]] static void refuse(const std::string& name) {
        throw FrameError(name + ": no process can be started to read it: " + std::strerror(errno));
    }

    FileDescriptor from_;
    pid_t id_ = 0;
    int status_ = 0;
};

}  // namespace

std::size_t address_space_bytes() {
    std::size_t pages = 0;
    std::ifstream{"/proc/self/statm"} >> pages;
    return pages * std::size_t(sysconf(_SC_PAGESIZE));
}

Bytes isolated(const std::string& name, const IsolationLimits& limits, const std::function<Bytes()>& work) {
    const Clock::time_point deadline = Clock::now() + limits.time;
    Copy copy(name, limits, work);
    Bytes sent;
    if (!copy.take(sent, deadline))
        throw FrameError(name + ": cannot be read within the time limit of " +
                         std::to_string(std::chrono::ceil<std::chrono::seconds>(limits.time).count()) + " s");
    const auto answer = whole_answer(sent);
    if (!answer) {
        const int status = copy.end();
        const int number = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        throw FrameError(name + ": cannot be read: its reader crashed (signal " + std::to_string(number) +
                         ", " + strsignal(number) + ")");
    }
    sent.erase(sent.begin(), sent.begin() + sizeof *answer);
    if (answer->kind == Answer::Kind::result) return sent;
    const std::string words(reinterpret_cast<const char*>(sent.data()), sent.size());
    throw FrameError(answer->kind == Answer::Kind::refusal ? words : name + ": cannot be read: " + words);
}

}  // namespace zproof::oracle
