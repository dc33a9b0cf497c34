#include "tests/cli/program.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace zproof::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in{file, std::ios::binary};
    if (!in) throw std::runtime_error{file.string() + ": cannot be read"};
    return {std::istreambuf_iterator<char>{in}, {}};
}

/// A terminal's other end reports EIO where a file reports its end.
std::string everything_from(int file) {
    std::string text;
    std::array<char, 4096> buffer;
    for (ssize_t n; (n = read(file, buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), std::size_t(n));
    return text;
}

std::vector<char*> as_argv(const Words& words) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    return argv;
}

/// Positions as little-endian float32 in base64, with their bounds.
struct Positions {
    std::string base64;
    int count;
    const char *min, *max;
};

std::string gltf_of(int mode, const Positions& positions) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "mode": )" +
           std::to_string(mode) + R"(}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": )" +
           std::to_string(positions.count) + R"(, "min": )" + positions.min + R"(, "max": )" + positions.max +
           R"(}],
        "bufferViews": [{"buffer": 0, "byteLength": )" +
           std::to_string(12 * positions.count) + R"(}],
        "buffers": [{"byteLength": )" +
           std::to_string(12 * positions.count) + R"(, "uri": "data:application/octet-stream;base64,)" +
           positions.base64 + R"("}]})";
}

/// (-1,-1,-3) (1,-1,-3) (0,1,-3).
constexpr const char* front = "AACAvwAAgL8AAEDAAACAPwAAgL8AAEDAAAAAAAAAgD8AAEDA";
/// (-1,1,-2.5) (0,-1,-3.5) (1,1,-3).
constexpr const char* across = "AACAvwAAgD8AACDAAAAAAAAAgL8AAGDAAACAPwAAgD8AAEDA";

const Positions three{front, 3, "[-1, -1, -3]", "[1, 1, -3]"};
const Positions six{std::string{front} + across, 6, "[-1, -1, -3.5]", "[1, 1, -2.5]"};

constexpr int points = 0, triangles = 4;

}  // namespace

std::string Folder::read(const fs::path& name) const { return text_of(path() / name); }

Words Folder::names() const {
    Words names;
    for (const auto& entry : fs::directory_iterator{path()})
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

pid_t start(const Folder& folder, const Words& arguments, Streams streams, const Words& environment) {
    Words words{ZPROOF_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    Words added = environment;
    const std::vector<char*> argv = as_argv(words), extra = as_argv(added);
    const pid_t pid = fork();
    if (pid != 0) return pid;
    for (char* entry : extra)
        if (entry != nullptr) putenv(entry);
    if (dup2(streams.out, STDOUT_FILENO) >= 0 && dup2(streams.err, STDERR_FILENO) >= 0 &&
        chdir(folder.path().c_str()) == 0)
        execv(argv[0], argv.data());
    _exit(126);
}

int exit_code_of(pid_t pid) {
    int status = 0;
    if (waitpid(pid, &status, 0) != pid) throw std::runtime_error{"the program was never started"};
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

Ran run(const Folder& folder, const Words& arguments, const Words& environment) {
    const Folder streams;
    const auto create = [&](const char* name) {
        return open((streams.path() / name).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
    };
    const Streams files{create("out"), create("err")};
    const pid_t pid = start(folder, arguments, files, environment);
    const int code = exit_code_of(pid);
    close(files.out);
    close(files.err);
    return {code, streams.read("out"), streams.read("err")};
}

Ran run_on_terminal(const Folder& folder, const Words& arguments, const Words& environment) {
    int here = -1, there = -1;
    if (openpty(&here, &there, nullptr, nullptr, nullptr) != 0)
        throw std::runtime_error{"no pseudo-terminal"};
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    const pid_t pid = start(folder, arguments, {there, nowhere}, environment);
    close(there);
    const std::string out = everything_from(here);
    const int code = exit_code_of(pid);
    close(here);
    close(nowhere);
    return {code, out, ""};
}

std::string one_triangle() { return gltf_of(triangles, three); }
std::string two_triangles() { return gltf_of(triangles, six); }
std::string point_cloud() { return gltf_of(points, three); }

}  // namespace zproof::test
