/// One axis of a table of repeated sums: what runs of wrapped texels, summed again and again, are made of.
///
/// With Q_1(k) = sum of t_i, i < k, and Q_n(k) = sum of Q_(n-1)(i), i < k, the n-fold sum of runs of w texels
/// is the n-th difference of Q_n at steps of w (Heckbert 1986, Filtering by repeated integration). All
/// coefficients are whole.
#pragma once

#include <cstdint>
#include <vector>

#include "texture/texels.h"

namespace zproof::texture {

/// A stored sum and how often it counts.
struct SumTerm {
    int index = 0;
    std::int64_t times = 0;
};

class RepeatedAxis {
  public:
    /// The greatest side of a run, texels: sums of order 3 of texels up to 2^16 then stay within 127 bits.
    static constexpr int longest_run = 4096;

    /// Order 2 or 3; size at least 1.
    RepeatedAxis(Wrap wrap, int size, int order) : wrap_{wrap}, size_{size}, order_{order} {}

    /// Entries of the table along this axis: a mirrored axis is stored with its mirror image.
    int stored() const { return wrap_ == Wrap::mirrored_repeat ? 2 * size_ : size_; }

    /// The order-fold sum of runs of `side` texels, the first of which begins at `first`, anywhere on the
    /// line: each stored sum at most once. 1 <= side <= longest_run.
    std::vector<SumTerm> runs(std::int64_t first, int side) const;

  private:
    using Terms = std::vector<SumTerm>;

    std::int64_t moved_near(std::int64_t first, int side) const;
    void add_stored(Terms& terms, std::int64_t k, std::int64_t times) const;
    void add_lower(Terms& terms, int order, std::int64_t k, std::int64_t times) const;
    void add_repeated(Terms& terms, std::int64_t k, std::int64_t times) const;
    void add_clamped(Terms& terms, std::int64_t k, std::int64_t times) const;

    Wrap wrap_;
    int size_, order_;
};

}  // namespace zproof::texture
