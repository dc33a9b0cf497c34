/// A harness hands bytes that nobody checked to one of zproof's readers. libfuzzer.cpp draws them; replay.cpp
/// takes them from files.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace zproof::fuzz {

using Input = std::span<const std::uint8_t>;

/// Each harness defines it, in a file of its own. A signal, a sanitizer's report or an exception that leaves
/// it is a finding.
void read_input(Input input);

/// Runs the work, which may throw one of these refusals and nothing else.
template <class Refusal, class... Refusals, class Work>
void may_refuse(const Work& work) {
    try {
        if constexpr (sizeof...(Refusals) > 0)
            may_refuse<Refusals...>(work);
        else
            work();
    } catch (const Refusal&) {
        return;
    }
}

/// What a reader must keep to for every input that it takes.
inline void require(bool holds, const std::string& rule) {
    if (!holds) throw std::logic_error(rule);
}

inline std::string text_of(Input input) { return {input.begin(), input.end()}; }

/// The input up to its first 0, and what follows that: readers of two texts take one input.
inline std::pair<Input, Input> split_at_zero(Input input) {
    const auto size = std::size_t(std::ranges::find(input, 0) - input.begin());
    return {input.first(size), input.subspan(std::min(size + 1, input.size()))};
}

}  // namespace zproof::fuzz
