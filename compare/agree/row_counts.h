/// The errors of rows of pixels, counted.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compare/verdict.h"

namespace zproof {

/// Pixels of a row that are counted together; a multiple of the lanes.
inline constexpr std::size_t row_pixels = 64;
template <class T>
using RowOf = std::array<T, row_pixels>;

/// What both frames show in a row, and error / bound of each. Beyond the image's right side both show
/// background.
struct ComparedRow {
    RowOf<PrimitiveId> candidate, reference;
    RowOf<double> candidate_error, reference_error;  ///< below 0: undecided
};

/// Counts the pixels at which both frames show the same triangle and both errors are decided.
class RowCounts {
  public:
    RowCounts() : pairs_(lanes * stride * stride) {}

    /// Is any pixel of the row undecided: are ids not the same, or an error?
    bool add(const ComparedRow& row);

    BoundRecord candidate() const;
    BoundRecord reference() const;

    static constexpr std::size_t lanes = 8, stride = 32;
    using Most = std::array<double, lanes>;

  private:
    template <class Add>
    void for_each_pair(const Add& add) const;

    Most candidate_most_{}, reference_most_{};
    std::vector<std::uint64_t> pairs_;  ///< by lane, bin of the candidate's error, bin of the reference's
};

/// Counts one more error.
void count(BoundRecord& record, double error_over_bound);
void add(BoundRecord& sum, const BoundRecord& part);

}  // namespace zproof
