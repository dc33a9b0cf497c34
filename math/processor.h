/// Instruction sets: what the processor has, and how much of it code may use that is compiled once for each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace zproof {

/// Each holds those before it.
enum class InstructionSet : std::uint8_t {
    scalar,  ///< what every processor has; on x86 that is SSE2
    avx2,
    avx512,  ///< its parts F, DQ, VL and BW
};

std::string_view name_of(InstructionSet set);

/// What this processor has, narrowest first; scalar alone on everything but x86.
const std::vector<InstructionSet>& instruction_sets();

/// A word that names no instruction set, or one that this processor does not have.
struct InstructionSetError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws InstructionSetError, which says what this processor has.
InstructionSet instruction_set_from(std::string_view word);

/// The widest that may run: what the processor has, up to what allow_at_most() or else the environment
/// variable ZPROOF_ISA says. No bit of any result depends on it. The first call throws InstructionSetError
/// where ZPROOF_ISA names none.
InstructionSet widest_allowed();

/// To be called before anything else runs, and on one thread.
void allow_at_most(InstructionSet set);

/// The one of `kernels` for widest_allowed(): code that is compiled once for each instruction set, in their
/// order.
template <class Kernel, std::size_t count>
const Kernel& widest_of(const Kernel* const (&kernels)[count]) {
    return *kernels[std::size_t(widest_allowed())];
}

/// Those of `kernels` that this processor can run, narrowest first.
template <class Kernel, std::size_t count>
std::vector<Kernel> available_of(const Kernel* const (&kernels)[count]) {
    std::vector<Kernel> available;
    for (const InstructionSet set : instruction_sets()) available.push_back(*kernels[std::size_t(set)]);
    return available;
}

}  // namespace zproof
