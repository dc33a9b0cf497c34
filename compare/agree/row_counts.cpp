#include "compare/agree/row_counts.h"

#include <algorithm>

#include "math/widest.h"

namespace zproof {

namespace {

constexpr int last_bin = std::tuple_size_v<BoundHistogram> - 1;
/// Stands for no bin.
constexpr int uncounted = last_bin + 1;
static_assert(uncounted < int(RowCounts::stride) && row_pixels % RowCounts::lanes == 0);

/// The bin of BoundHistogram for an error that is a number.
[[gnu::always_inline]] inline int bin_of(double error) {
    const double scaled = error * last_bin;
    return int(scaled < last_bin ? scaled : last_bin);
}

/// Writes the bins of each pixel, and raises the largest errors. Is any pixel undecided?
bool set_bins(const ComparedRow& row, RowCounts::Most& candidate, RowCounts::Most& reference,
              RowOf<int>& pairs) {
    RowCounts::Most most = candidate, most_of_reference = reference;
    int undecided = 0;
    for (std::size_t first = 0; first < row_pixels; first += RowCounts::lanes)
        for (std::size_t lane = 0; lane < RowCounts::lanes; ++lane) {
            const std::size_t i = first + lane;
            const double a = row.candidate_error[i], b = row.reference_error[i];
            const bool is_decided = (row.candidate[i] == row.reference[i]) & (a >= 0) & (b >= 0);
            const bool is_counted = is_decided & (row.candidate[i] != PrimitiveId::none);
            undecided |= !is_decided;
            pairs[i] = is_counted ? bin_of(a) * int(RowCounts::stride) + bin_of(b) : uncounted;
            most[lane] = (is_counted & (a > most[lane])) ? a : most[lane];
            most_of_reference[lane] =
                (is_counted & (b > most_of_reference[lane])) ? b : most_of_reference[lane];
        }
    candidate = most;
    reference = most_of_reference;
    return undecided != 0;
}

}  // namespace

bool RowCounts::add(const ComparedRow& row) {
    RowOf<int> pairs;
    const bool is_any_undecided = widest<set_bins>(row, candidate_most_, reference_most_, pairs);
    for (std::size_t i = 0; i < row_pixels; ++i)
        ++pairs_[i % lanes * stride * stride + std::size_t(pairs[i])];
    return is_any_undecided;
}

/// Calls add(bin of the candidate's error, bin of the reference's, pixels).
template <class Add>
void RowCounts::for_each_pair(const Add& add) const {
    for (std::size_t lane = 0; lane < lanes; ++lane)
        for (std::size_t a = 0; a < uncounted; ++a)
            for (std::size_t b = 0; b < uncounted; ++b) add(a, b, pairs_[(lane * stride + a) * stride + b]);
}

BoundRecord RowCounts::candidate() const {
    BoundRecord record{.max_error_over_bound = std::ranges::max(candidate_most_)};
    for_each_pair(
        [&](std::size_t bin, std::size_t, std::uint64_t pixels) { record.histogram[bin] += pixels; });
    return record;
}

BoundRecord RowCounts::reference() const {
    BoundRecord record{.max_error_over_bound = std::ranges::max(reference_most_)};
    for_each_pair(
        [&](std::size_t, std::size_t bin, std::uint64_t pixels) { record.histogram[bin] += pixels; });
    return record;
}

void count(BoundRecord& record, double error_over_bound) {
    record.max_error_over_bound = std::max(record.max_error_over_bound, error_over_bound);
    const double bin = std::min(error_over_bound * last_bin, double(last_bin));
    ++record.histogram[bin >= 0 ? std::size_t(bin) : last_bin];
}

void add(BoundRecord& sum, const BoundRecord& part) {
    sum.max_error_over_bound = std::max(sum.max_error_over_bound, part.max_error_over_bound);
    for (std::size_t i = 0; i < sum.histogram.size(); ++i) sum.histogram[i] += part.histogram[i];
}

}  // namespace zproof
