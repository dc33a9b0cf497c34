#include "cli/gate/shard.h"

#include <array>
#include <charconv>
#include <fstream>
#include <limits>
#include <string>

#include "frame/joined.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

/// Where somebody says it. An absent count, origin or step is an empty name.
struct ShardVariables {
    const char *index, *count;
    int origin = 0;                                   ///< the first index
    const char *origin_is_in = "", *step_is_in = "";  ///< which may be said, too
};

constexpr std::array conventions{
    ShardVariables{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", 0, "SLURM_ARRAY_TASK_MIN",
                   "SLURM_ARRAY_TASK_STEP"},
    ShardVariables{"CI_NODE_INDEX", "CI_NODE_TOTAL", 1},
    ShardVariables{"JOB_COMPLETION_INDEX", ""},
    ShardVariables{"TEST_SHARD_INDEX", "TEST_TOTAL_SHARDS"},
    ShardVariables{"PMI_RANK", "PMI_SIZE"},
    ShardVariables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
};

bool is_set(const char* text) { return text != nullptr && *text != '\0'; }

int number_in(const char* name, const std::string& text) {
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec == std::errc{} && read.ptr == end && value >= 0) return value;
    throw UsageError{std::string{"--shard auto: expected a whole number in "} + name + ", found '" + text +
                     "'"};
}

/// `otherwise` where the variable has no name or is not set.
int number_of(const Environment& environment, const char* name, int otherwise) {
    const char* const text = *name == '\0' ? nullptr : environment(name);
    return is_set(text) ? number_in(name, text) : otherwise;
}

Shard shard_by(const ShardVariables& convention, const Environment& environment) {
    const int index = number_of(environment, convention.index, 0);
    const int origin = number_of(environment, convention.origin_is_in, convention.origin);
    const int step = std::max(1, number_of(environment, convention.step_is_in, 1));
    const int count = number_of(environment, convention.count, 0);
    const int number = index < origin ? 0 : (index - origin) / step + 1;
    if (number < 1 || number > (count > 0 ? count : most_shards))
        throw UsageError{std::string{"--shard auto: "} + convention.index + " is " + std::to_string(index) +
                         ", of " + std::to_string(count) + " that begin at " + std::to_string(origin)};
    return {.number = number, .count = count, .taken_from = convention.index};
}

/// Bazel's runner asks for it: "Test Encyclopedia", test sharding.
void show_that_it_is_listened_to(const Environment& environment) {
    if (const char* file = environment("TEST_SHARD_STATUS_FILE"); is_set(file))
        std::ofstream{file, std::ios::app};
}

std::string all_indices() { return joined(conventions, ", ", &ShardVariables::index); }

}  // namespace

Shard shard_of_environment(const Environment& environment) {
    for (const ShardVariables& convention : conventions)
        if (is_set(environment(convention.index))) {
            const Shard shard = shard_by(convention, environment);
            if (shard.taken_from == "TEST_SHARD_INDEX") show_that_it_is_listened_to(environment);
            return shard;
        }
    throw UsageError{"--shard auto: expected one of " + all_indices() + " in the environment"};
}

}  // namespace zproof
