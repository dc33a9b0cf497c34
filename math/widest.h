/// Plain loops that the compiler builds once per instruction set. The widest that is allowed runs.
#pragma once

#include "math/processor.h"

namespace zproof {

/// A function, compiled for each instruction set with everything in it that can be inlined. A call is a call
/// of the function: widest<sum>(numbers). Nothing that it computes may depend on the width of vectors;
/// contraction of floating-point operations is off.
template <auto function, InstructionSet most>
struct Widest;

template <class Result, class... Arguments, Result (*function)(Arguments...), InstructionSet most>
struct Widest<function, most> {
    Result operator()(Arguments... arguments) const {
#ifdef __x86_64__
        const InstructionSet allowed = widest_allowed();
        if constexpr (most >= InstructionSet::avx512)
            if (allowed >= InstructionSet::avx512) return avx512(arguments...);
        if (allowed >= InstructionSet::avx2) return avx2(arguments...);
#endif
        return function(arguments...);
    }

  private:
#ifdef __x86_64__
    [[gnu::target("avx2"), gnu::flatten]] static Result avx2(Arguments... arguments) {
        return function(arguments...);
    }
    [[gnu::target("avx512f,avx512dq,avx512vl,avx512bw"), gnu::flatten]] static Result avx512(
        Arguments... arguments) {
        return function(arguments...);
    }
#endif
};

/// most: the widest that is worth its code.
template <auto function, InstructionSet most = InstructionSet::avx512>
inline constexpr Widest<function, most> widest{};

}  // namespace zproof
