#include "compare/presort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

namespace zproof {

namespace {

/// Worth an estimate each.
constexpr std::size_t most_laws = 2;

/// Do both frames show one triangle only?
[[gnu::target_clones("default", "avx2", "avx512f")]] bool is_one_law(const std::uint32_t* ours,
                                                                     const std::uint32_t* theirs) {
    std::uint32_t difference = 0;
    for (std::size_t i = 0; i < Strip::chunk; ++i) difference |= (ours[i] ^ ours[0]) | (theirs[i] ^ ours[0]);
    return difference == 0;
}

struct Agreement {
    ColumnMask same = 0, bare = 0;  ///< ids; nothing in either frame
};
[[gnu::target_clones("default", "avx2", "avx512f")]] Agreement agreement(const Strip& strip,
                                                                         std::size_t first) {
    constexpr float none = std::numeric_limits<float>::infinity();
    const PrimitiveId *ours = &strip.candidate.primitive[first], *theirs = &strip.reference.primitive[first];
    const float *our_depth = &strip.candidate.camera_depth[first],
                *their_depth = &strip.reference.camera_depth[first];
    std::uint32_t same = 0, bare = 0;
    for (std::size_t i = 0; i < Strip::chunk; ++i) {
        const bool agree = ours[i] == theirs[i];
        const bool are_bare =
            agree & (ours[i] == PrimitiveId::none) & (our_depth[i] == none) & (their_depth[i] == none);
        same |= std::uint32_t(agree) << i;
        bare |= std::uint32_t(are_bare) << i;
    }
    return {same, bare};
}

[[gnu::target_clones("default", "avx2", "avx512f")]] ColumnMask equal_laws(const std::uint32_t* laws,
                                                                           std::uint32_t law) {
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < Strip::chunk; ++i) mask |= std::uint32_t(laws[i] == law) << i;
    return mask;
}

/// Rounded down.
float times_20(double ratio) { return float(ratio * 20 * (1 - 0x1p-20)); }

}  // namespace

void Presort::sort(const LawsOfBoth& laws, Largest& largest, Strip& strip) {
    known_.resize(std::max(known_.size(), laws.candidate.size()));
    const KnownLargest known{times_20(largest.candidate), times_20(largest.reference)};
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk) {
        const bool one = is_one_law(&strip.candidate.law[first], &strip.reference.law[first]);
        const Source source{laws, known, largest, strip, first};
        const bool is_sorted = one && strip.candidate.law[first] != 0 ? sort_one_law(source, strip)
                                                                      : sort_some_laws(source, strip);
        strip.sorted |= std::uint32_t(is_sorted) << first / Strip::chunk;
    }
}

const DepthEstimate& Presort::estimate_by(const LawsOfBoth& laws, std::uint32_t law) {
    Known& known = known_[law];
    if (known.tile != tile_)
        known = {.tile = tile_,
                 .estimate = estimate_of(laws.candidate[law], laws.reference[law], projection_)};
    return known.estimate;
}

/// Of pixels at which both frames show the triangle. What may exceed the largest ratio is worked out in full.
bool Presort::are_known(const EstimatedRow& row, std::uint32_t law, ColumnMask pixels, const Source& source) {
    if ((pixels & ~(row.candidate.certain & row.reference.certain)) != 0) return false;
    Known& known = known_[law];
    raise({source.laws.candidate[law], source.strip.candidate, pixels & row.candidate.may_exceed}, source,
          known.candidate_counted, source.largest.candidate);
    raise({source.laws.reference[law], source.strip.reference, pixels & row.reference.may_exceed}, source,
          known.reference_counted, source.largest.reference);
    return true;
}

/// On a triangle at one depth all over the image, a depth that was counted need not be counted again.
void Presort::raise(const Exceeding& pixels, const Source& source, float& counted, double& largest) const {
    if (pixels.mask == 0) return;
    TileRowOf<float> depth;
    std::copy_n(&pixels.shown.camera_depth[source.first], tile_columns, depth.begin());
    const bool is_level = pixels.law.nearness_per_x == 0 && pixels.law.nearness_per_y == 0;
    const ColumnMask asked = is_level ? pixels.mask & ~equal(depth, counted) : pixels.mask;
    if (asked == 0) return;
    const RowPlace place{source.strip.x + int(source.first), source.strip.y};
    const TileRow ratio = depths_in_row(pixels.law, projection_, place, depth).ratio;
    for (ColumnMask rest = asked; rest != 0; rest &= rest - 1)
        largest = std::max(largest, ratio[std::size_t(std::countr_zero(rest))]);
    counted = depth[std::size_t(std::countr_zero(asked))];
}

/// Nothing is certain where a law cannot be estimated.
EstimatedRow Presort::estimated(std::uint32_t law, const Source& source) {
    EstimatedRow row;
    const DepthEstimate& triangle = estimate_by(source.laws, law);
    const Strip& strip = source.strip;
    if (triangle.is_usable)
        estimate(triangle, projection_, {strip.x + int(source.first), strip.y},
                 &strip.candidate.camera_depth[source.first], &strip.reference.camera_depth[source.first],
                 source.known, row);
    return row;
}

bool Presort::sort_one_law(const Source& source, Strip& strip) {
    const std::uint32_t law = strip.candidate.law[source.first];
    const EstimatedRow row = estimated(law, source);
    if (!are_known(row, law, all_columns, source)) return false;
    std::ranges::copy(row.candidate.bin, &strip.candidate.bin[source.first]);
    std::ranges::copy(row.reference.bin, &strip.reference.bin[source.first]);
    strip.open[source.first / Strip::chunk] = 0;
    strip.lawful[source.first / Strip::chunk] = 0;
    return true;
}

bool Presort::sort_some_laws(const Source& source, Strip& strip) {
    const std::size_t first = source.first;
    const auto [same, bare] = agreement(strip, first);
    const std::uint32_t *ours = &strip.candidate.law[first], *theirs = &strip.reference.law[first];
    const ColumnMask nothing = equal_laws(ours, 0);
    if ((nothing & same & ~bare) != 0) return false;
    std::array<Share, most_laws> shares;
    std::size_t count = 0;
    ColumnMask rest = ~nothing & all_columns, rest_of_theirs = ~equal_laws(theirs, 0) & all_columns;
    for (; (rest | rest_of_theirs) != 0; ++count) {
        if (count == most_laws) return false;
        const std::uint32_t law =
            rest != 0 ? ours[std::countr_zero(rest)] : theirs[std::countr_zero(rest_of_theirs)];
        shares[count] = {law, equal_laws(ours, law), equal_laws(theirs, law)};
        rest &= ~shares[count].candidate;
        rest_of_theirs &= ~shares[count].reference;
    }
    TileRowOf<std::int32_t> our_bin, their_bin;
    our_bin.fill(Strip::uncounted), their_bin.fill(Strip::uncounted);
    ColumnMask lawful = 0, lawful_of_theirs = 0;
    for (const Share& share : std::span(shares).first(count)) {
        const EstimatedRow row = estimated(share.law, source);
        const ColumnMask agreed = share.candidate & same;
        if (!are_known(row, share.law, agreed, source)) return false;
        our_bin = chosen(our_bin, row.candidate.bin, agreed);
        their_bin = chosen(their_bin, row.reference.bin, agreed);
        lawful |= share.candidate & row.candidate.certain;
        lawful_of_theirs |= share.reference & row.reference.certain;
    }
    std::ranges::copy(our_bin, &strip.candidate.bin[first]);
    std::ranges::copy(their_bin, &strip.reference.bin[first]);
    strip.open[first / Strip::chunk] = ~same & all_columns;
    strip.lawful[first / Strip::chunk] = lawful & lawful_of_theirs & ~same;
    return true;
}

}  // namespace zproof
