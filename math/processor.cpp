#include "math/processor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>

namespace zproof {
namespace {

constexpr std::array<std::string_view, 3> names{"scalar", "avx2", "avx512"};

#ifdef __x86_64__
bool has_avx2() { return __builtin_cpu_supports("avx2"); }

bool has_avx512() {
    return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}
#else
bool has_avx2() { return false; }
bool has_avx512() { return false; }
#endif

std::string listed(const auto& words) {
    std::string list;
    for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + std::string(word);
    return list;
}

InstructionSet wanted_by_environment() {
    const char* const word = std::getenv("ZPROOF_ISA");
    if (word == nullptr || *word == '\0') return InstructionSet::avx512;
    try {
        return instruction_set_from(word);
    } catch (const InstructionSetError& e) {
        throw InstructionSetError(std::string("ZPROOF_ISA: ") + e.what());
    }
}

std::atomic<InstructionSet>& allowed() {
    static std::atomic<InstructionSet> set{std::min(wanted_by_environment(), instruction_sets().back())};
    return set;
}

}  // namespace

std::string_view name_of(InstructionSet set) { return names.at(std::size_t(set)); }

const std::vector<InstructionSet>& instruction_sets() {
    static const std::vector<InstructionSet> here = [] {
        std::vector<InstructionSet> sets{InstructionSet::scalar};
        if (has_avx2()) sets.push_back(InstructionSet::avx2);
        if (has_avx512()) sets.push_back(InstructionSet::avx512);
        return sets;
    }();
    return here;
}

InstructionSet instruction_set_from(std::string_view word) {
    std::vector<std::string_view> here;
    for (const InstructionSet set : instruction_sets()) {
        if (word == name_of(set)) return set;
        here.push_back(name_of(set));
    }
    if (std::ranges::find(names, word) != names.end())
        throw InstructionSetError("this processor has no " + std::string(word) + ", only " + listed(here));
    throw InstructionSetError("expected one of " + listed(here) + ", found '" + std::string(word) + "'");
}

InstructionSet widest_allowed() { return allowed().load(std::memory_order_relaxed); }

void allow_at_most(InstructionSet set) { allowed() = std::min(set, instruction_sets().back()); }

}  // namespace zproof
