/// How much of each texel an interval of a wrapped axis covers, and the prefix sums that tell it.
#pragma once

#include <array>
#include <span>

#include "texture/texels.h"

namespace zproof::texture {

/// An interval of texel coordinates, anywhere on the line; low < high, both finite and below 2^51 in size.
struct Extent {
    double low = 0, high = 0;
};

/// Texels [first, last) of an axis, each with this weight; first < last.
struct Run {
    int first = 0, last = 0;
    double weight = 0;
};

/// A sum over texels [0, count) of an axis, with its weight; 1 <= count <= size.
struct Prefix {
    int count = 0;
    double weight = 0;
};

/// Up to five of a kind: the ends' shares, what lies between them, and whole periods.
template <class Part>
struct Parts {
    std::array<Part, 5> parts{};
    std::size_t count = 0;

    void add(const Part& part) { parts.at(count++) = part; }
    std::span<const Part> all() const& { return {parts.data(), count}; }
    std::span<const Part> all() const&& = delete;  // it would outlive them: give the parts a name first
};

/// The mean over the interval of the piecewise-constant texture, as the weights of texels: all positive, of
/// sum 1.
Parts<Run> covered(const Extent& extent, Wrap wrap, int size);

/// The mean as Crow (1984) reads it: each end interpolated between two prefix sums, and the sum of the whole
/// axis where the ends lie in different periods. Weights are of either sign; sums over no texel are left out.
Parts<Prefix> prefixes(const Extent& extent, Wrap wrap, int size);

}  // namespace zproof::texture
