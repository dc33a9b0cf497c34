#include "frame/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "frame/frame_error.h"

namespace zproof {
namespace {

std::string in_words(int error) {
    if (error == ENOENT || error == ENOTDIR) return "no such file";
    if (error == ELOOP) return "is a loop of links";
    return std::strerror(error);
}

/// What a file is that is no regular one; empty for a regular one.
std::string kind_fault(const struct stat& facts) {
    if (S_ISREG(facts.st_mode)) return "";
    if (S_ISDIR(facts.st_mode)) return "is a folder";
    if (S_ISFIFO(facts.st_mode)) return "is a pipe";
    return S_ISSOCK(facts.st_mode) ? "is a socket" : "is a device";
}

/// A regular file, open for reading, or what keeps it from being so.
class Input {
  public:
    explicit Input(const std::filesystem::path& file) {
        struct stat facts {};
        if (stat(file.c_str(), &facts) != 0) {
            fault_ = in_words(errno);
            return;
        }
        fault_ = kind_fault(facts);
        if (!fault_.empty()) return;
        descriptor_ = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        if (descriptor_ < 0 || fstat(descriptor_, &facts) != 0)
            fault_ = in_words(errno);
        else
            fault_ = kind_fault(facts);  // it may be another one than a moment ago
        piece_ = std::size_t(std::clamp<off_t>(facts.st_size, 4095, (1 << 20) - 1)) + 1;
    }
    ~Input() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    const std::string& fault() const { return fault_; }

    /// The bytes from here on, at most so many.
    std::string read(std::uint64_t most) {
        std::string bytes;
        for (ssize_t got = 1; got != 0 && bytes.size() < most;) {
            const std::size_t before = bytes.size();
            bytes.resize(before + std::size_t(std::min<std::uint64_t>(piece_, most - before)));
            do got = ::read(descriptor_, bytes.data() + before, bytes.size() - before);
            while (got < 0 && errno == EINTR);
            if (got < 0) fault_ = in_words(errno);
            got = std::max<ssize_t>(got, 0);
            bytes.resize(before + std::size_t(got));
        }
        return bytes;
    }

  private:
    int descriptor_ = -1;
    std::size_t piece_ = 0;  ///< bytes to ask for at once: the whole file, where that is not too many
    std::string fault_;
};

}  // namespace

std::string fault_of_input(const std::filesystem::path& file) { return Input(file).fault(); }

std::string read_input(const std::filesystem::path& file, const ExpectedInput& expected) {
    Input input(file);
    std::string bytes = input.fault().empty() ? input.read(expected.most_bytes + 1) : "";
    std::string fault = input.fault();
    if (bytes.size() > expected.most_bytes)
        fault = "more than " + std::to_string(expected.most_bytes) + " bytes";
    if (!fault.empty()) throw FrameError(file.string() + ": " + fault + "; expected " + expected.words);
    return bytes;
}

}  // namespace zproof
