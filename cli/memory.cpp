#include "cli/memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "frame/frame.h"
#include "frame/number_text.h"
#include "frame/whole_file.h"
#include "oracle/isolated.h"
#include "reports/wording.h"

namespace zproof {
namespace {

constexpr std::uint64_t unlimited_bytes = std::numeric_limits<std::uint64_t>::max();
constexpr const char* remedy =
    "; make the picture smaller, free memory, or raise the limit (ulimit -v, or the container's)";

/// The machine's; unlimited where the system does not tell.
std::uint64_t left_on_machine() {
    std::istringstream facts(content_of("/proc/meminfo"));
    std::uint64_t kib = 0, left_kib = 0;
    bool is_known = false;
    for (std::string name, line; facts >> name && std::getline(facts, line);) {
        if (name != "MemAvailable:" && name != "SwapFree:") continue;
        if (std::istringstream(line) >> kib) left_kib += kib, is_known |= name == "MemAvailable:";
    }
    return is_known ? left_kib * 1024 : unlimited_bytes;
}

/// Bytes that the process's own limit leaves.
std::uint64_t left_of_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited_bytes;
    return limit.rlim_cur - std::min<std::uint64_t>(oracle::address_space_bytes(), limit.rlim_cur);
}

std::optional<std::uint64_t> number_in(const std::filesystem::path& file) {
    std::istringstream text(content_of(file));
    std::uint64_t number = 0;
    return text >> number ? std::optional(number) : std::nullopt;  // "max": no limit
}

/// Pages of files, which the system drops where it needs the memory.
std::uint64_t droppable_bytes(const std::filesystem::path& group) {
    std::istringstream facts(content_of(group / "memory.stat"));
    std::uint64_t sum = 0, bytes = 0;
    for (std::string name; facts >> name >> bytes;)
        if (name == "active_file" || name == "inactive_file") sum += bytes;
    return sum;
}

std::uint64_t left_of_group(const std::filesystem::path& group) {
    const auto most = number_in(group / "memory.max");
    if (!most) return unlimited_bytes;
    const std::uint64_t used = number_in(group / "memory.current").value_or(0),
                        held = used - std::min(used, droppable_bytes(group));
    return *most - std::min(*most, held);
}

/// "/a/b" of the line "0::/a/b"; empty where there is none.
std::string group_in(const std::string& groups) {
    std::istringstream lines(groups);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("0::/")) return line.substr(3);
    return "";
}

std::string in_gib(std::uint64_t bytes) { return fixed(double(bytes) / double(1 << 30), 2) + " GiB"; }

std::string pixels_in_words(Resolution size) { return size_text(size.width, size.height) + " pixels"; }

}  // namespace

std::uint64_t memory_left_of_groups(const std::string& groups, const std::filesystem::path& root) {
    const std::filesystem::path own = std::filesystem::path(group_in(groups)).relative_path();
    std::uint64_t left = left_of_group(root);
    std::filesystem::path group = root;
    for (const std::filesystem::path& name : own) left = std::min(left, left_of_group(group /= name));
    return left;
}

std::uint64_t available_memory_bytes() {
    return std::min({left_on_machine(), left_of_limit(),
                     memory_left_of_groups(content_of("/proc/self/cgroup"), "/sys/fs/cgroup")});
}

std::uint64_t least_memory_bytes(Resolution size) {
    constexpr std::uint64_t frame = sizeof(PrimitiveId) + sizeof(float), verdict = 1;
    return std::uint64_t(size.width) * std::uint64_t(size.height) * (2 * frame + verdict);
}

std::string lacking_memory(Resolution size) {
    const std::uint64_t needed = least_memory_bytes(size), there = available_memory_bytes();
    if (needed <= there) return "";
    return pixels_in_words(size) + " need at least " + in_gib(needed) + " of memory, of which " +
           in_gib(there) + " is there" + remedy;
}

void require_memory(Resolution size) {
    if (const std::string lacking = lacking_memory(size); !lacking.empty()) throw std::runtime_error{lacking};
}

std::string out_of_memory(Resolution size, std::uint64_t triangles) {
    return "out of memory: " + pixels_in_words(size) + " and " + counted(triangles, "triangle") +
           " need more than " + in_gib(available_memory_bytes()) + ", which is left" + remedy;
}

std::string out_of_memory_for(const std::string& scene) {
    return "out of memory while " + scene + " was read and built; " + in_gib(available_memory_bytes()) +
           " are left; split the scene, free memory, or raise the limit (ulimit -v)";
}

}  // namespace zproof
