#include "compare/presort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "compare/masks.h"
#include "compare/runs.h"

namespace zproof {

namespace {

/// Where the candidate shows nothing, and both have the depth of the background.
ColumnMask bare(const Strip& strip, std::size_t first) {
    const ColumnMask nothing = where_equal(&strip.candidate.primitive[first], PrimitiveId::none);
    if (nothing == 0) return 0;
    return nothing & where_equal(&strip.candidate.camera_depth[first], background_depth) &
           where_equal(&strip.reference.camera_depth[first], background_depth);
}

constexpr auto none_counted = [] {
    TileRowOf<std::int32_t> bins{};
    bins.fill(SortedStrip::uncounted);
    return bins;
}();

/// Of some pixels; the others are not counted.
void copy_bins(const EstimatedRow::Side& from, ColumnMask pixels, std::size_t chunk, SortedStrip::Side& to) {
    std::int32_t* const bin = &to.bin[chunk * Strip::chunk];
    to.bins[chunk] = pixels == 0 ? SortedStrip::Bins::uncounted : SortedStrip::Bins::each;
    if (pixels == all_columns && from.is_quiet)
        to.bins[chunk] = SortedStrip::Bins::first;
    else if (pixels == all_columns)
        std::ranges::copy(from.bin, bin);
    else if (pixels != 0)
        std::ranges::copy(chosen(none_counted, from.bin, pixels), bin);
}

/// Where one chunk is not quiet, the next ones of the strip are hardly either.
void expect_the_like_of(const EstimatedRow& row, Asked& asked) {
    asked.may_be_quiet = {row.candidate.is_quiet, row.reference.is_quiet};
}

/// Rounded down.
float times_20(double ratio) { return float(ratio * 20 * (1 - 0x1p-20)); }

}  // namespace

void Presort::sort(const LawsOfBoth& laws, Largest& largest, const Strip& strip, SortedStrip& sorted) {
    known_.resize(std::max(known_.size(), laws.candidate.size()));
    Asked asked{projection_, {times_20(largest.candidate), times_20(largest.reference)}};
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk) {
        constexpr ColumnMask but_first = all_columns & ~ColumnMask{1};
        const bool one =
            ((Strip::in_chunk(strip.turns, first) & but_first) | Strip::in_chunk(strip.differ, first)) == 0;
        const Source source{laws, asked, largest, strip, first};
        const bool is_sorted = one && strip.candidate.law[first] != 0 ? sort_one_law(source, sorted)
                                                                      : sort_some_laws(source, sorted);
        sorted.sorted |= std::uint32_t(is_sorted) << first / Strip::chunk;
    }
}

const DepthEstimate& Presort::estimate_by(const Source& source, std::uint32_t law) {
    Known& known = known_[law];
    if (known.tile != tile_) {
        const auto& [candidate, reference] = source.laws;
        known = {.tile = tile_,
                 .estimate = estimate_of(candidate[law], reference[law], projection_, source.asked.known)};
    }
    return known.estimate;
}

/// Of pixels at which both frames show the same triangle: what may exceed the largest ratio is worked out in
/// full.
void Presort::raise_largest(const EstimatedRow& row, ColumnMask pixels, const Source& source) {
    const std::uint32_t* laws = &source.strip.candidate.law[source.first];
    ColumnMask rest = pixels & (row.candidate.may_exceed | row.reference.may_exceed);
    while (rest != 0) {
        const std::uint32_t law = laws[std::countr_zero(rest)];
        const ColumnMask here = rest & where_equal(laws, law);
        rest &= ~here;
        Known& known = known_[law];
        raise({source.laws.candidate[law], source.strip.candidate, here & row.candidate.may_exceed}, source,
              known.candidate_counted, source.largest.candidate);
        raise({source.laws.reference[law], source.strip.reference, here & row.reference.may_exceed}, source,
              known.reference_counted, source.largest.reference);
    }
}

/// On a triangle at one depth all over the image, a depth that was counted need not be counted again.
void Presort::raise(const Exceeding& pixels, const Source& source, float& counted, double& largest) const {
    if (pixels.mask == 0) return;
    TileRowOf<float> depth;
    std::copy_n(&pixels.shown.camera_depth[source.first], tile_columns, depth.begin());
    const bool is_level = pixels.law.nearness_per_x == 0 && pixels.law.nearness_per_y == 0;
    const ColumnMask asked = is_level ? pixels.mask & ~where_equal(depth.data(), counted) : pixels.mask;
    if (asked == 0) return;
    const RowPlace place{source.strip.x + int(source.first), source.strip.y};
    const TileRow ratio = depths_in_row(pixels.law, projection_, place, depth).ratio;
    for (ColumnMask rest = asked; rest != 0; rest &= rest - 1)
        largest = std::max(largest, ratio[std::size_t(std::countr_zero(rest))]);
    counted = depth[std::size_t(std::countr_zero(asked))];
}

DepthsOfBoth Presort::depths_of(const Source& source) {
    const Strip& strip = source.strip;
    return {{strip.x + int(source.first), strip.y},
            &strip.candidate.camera_depth[source.first],
            &strip.reference.camera_depth[source.first]};
}

/// As if all pixels showed that triangle.
EstimatedRow Presort::estimated_by_one(std::uint32_t law, const Source& source) {
    EstimatedRow row;
    const DepthEstimate& triangle = estimate_by(source, law);
    if (!triangle.is_usable) return row;
    estimate(triangle, source.asked, depths_of(source), row);
    expect_the_like_of(row, source.asked);
    return row;
}

/// Once for every run of pixels that show the same.
void Presort::set_estimates_of_candidate(const Source& source, Estimates& each) {
    const std::uint32_t* law = &source.strip.candidate.law[source.first];
    const ColumnMask turns = Strip::in_chunk(source.strip.turns, source.first) | 1;
    spread_over_runs<tile_columns>(
        turns, [&](std::size_t first) { return &estimate_by(source, law[first]); }, each);
}

Estimates Presort::estimates_of_reference(const Estimates& of_candidate, const Source& source) {
    Estimates each = of_candidate;
    for (ColumnMask rest = Strip::in_chunk(source.strip.differ, source.first); rest != 0; rest &= rest - 1) {
        const auto i = std::size_t(std::countr_zero(rest));
        each[i] = &estimate_by(source, source.strip.reference.law[source.first + i]);
    }
    return each;
}

/// Each by what it shows; of the other pixels it does not matter.
EstimatedRow Presort::estimated_by_each(ColumnMask pixels, const Source& source) {
    Asked asked = source.asked;
    asked.pixels = pixels;
    Estimates ours;
    set_estimates_of_candidate(source, ours);
    EstimatedRow row;
    if (Strip::in_chunk(source.strip.differ, source.first) == 0)
        estimate({ours, ours}, asked, depths_of(source), row);
    else
        estimate({ours, estimates_of_reference(ours, source)}, asked, depths_of(source), row);
    expect_the_like_of(row, source.asked);
    return row;
}

bool Presort::sort_one_law(const Source& source, SortedStrip& sorted) {
    const EstimatedRow row = estimated_by_one(source.strip.candidate.law[source.first], source);
    return settle(row, {all_columns, all_columns}, source, sorted);
}

bool Presort::sort_some_laws(const Source& source, SortedStrip& sorted) {
    const ColumnMask same = ~Strip::in_chunk(source.strip.differ, source.first) & all_columns;
    const ColumnMask in_question = all_columns & ~(same & bare(source.strip, source.first));
    if (in_question == 0) return settle({}, {same, 0}, source, sorted);
    return settle(estimated_by_each(in_question, source), {same, same & in_question}, source, sorted);
}

/// Unless one of the pixels that agree is not certain.
bool Presort::settle(const EstimatedRow& row, const Agreement& pixels, const Source& source,
                     SortedStrip& sorted) {
    const ColumnMask certain = row.candidate.certain & row.reference.certain;
    if ((pixels.agreed & ~certain) != 0) return false;
    raise_largest(row, pixels.agreed, source);
    const std::size_t chunk = source.first / Strip::chunk;
    copy_bins(row.candidate, pixels.agreed, chunk, sorted.candidate);
    copy_bins(row.reference, pixels.agreed, chunk, sorted.reference);
    sorted.open[chunk] = ~pixels.same & all_columns;
    sorted.lawful[chunk] = sorted.open[chunk] & certain;
    return true;
}

}  // namespace zproof
