#include "compare/presort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

namespace zproof {

namespace {

/// Worth an estimate each.
constexpr std::size_t most_laws = 4;

/// Do both frames show one triangle only?
[[gnu::target_clones("default", "avx2", "avx512f")]] bool is_one_law(const std::uint32_t* ours,
                                                                     const std::uint32_t* theirs) {
    std::uint32_t difference = 0;
    for (std::size_t i = 0; i < Strip::chunk; ++i)
        difference |= (ours[i] ^ ours[0]) | (theirs[i] ^ ours[0]);
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

/// Pixels of a chunk that show one triangle in both frames.
struct Share {
    std::uint32_t law;
    ColumnMask pixels;
};

[[gnu::target_clones("default", "avx2", "avx512f")]] void take(const TileRowOf<std::int32_t>& some,
                                                               ColumnMask pixels,
                                                               TileRowOf<std::int32_t>& all) {
    for (std::size_t i = 0; i < tile_columns; ++i)
        all[i] = (pixels & std::uint32_t{1} << i) != 0 ? some[i] : all[i];
}

}  // namespace

void Presort::sort(const LawsOfBoth& laws, const KnownLargest& largest, Strip& strip) {
    known_.resize(std::max(known_.size(), laws.candidate.size()));
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk) {
        const bool one = is_one_law(&strip.candidate.law[first], &strip.reference.law[first]);
        const bool is_sorted = one && strip.candidate.law[first] != 0
                                   ? sort_one_law(laws, largest, first, strip)
                                   : sort_some_laws(laws, largest, first, strip);
        strip.sorted |= std::uint32_t(is_sorted) << first / Strip::chunk;
    }
}

const DepthEstimate& Presort::estimate_by(const LawsOfBoth& laws, std::uint32_t law) {
    Known& known = known_[law];
    if (known.tile != tile_)
        known = {tile_, estimate_of(laws.candidate[law], laws.reference[law], projection_)};
    return known.estimate;
}

bool Presort::sort_one_law(const LawsOfBoth& laws, const KnownLargest& largest, std::size_t first,
                           Strip& strip) {
    const DepthEstimate& triangle = estimate_by(laws, strip.candidate.law[first]);
    if (!triangle.is_usable) return false;
    EstimatedRow row;
    estimate(triangle, projection_, {strip.x + int(first), strip.y}, &strip.candidate.camera_depth[first],
             &strip.reference.camera_depth[first], largest, row);
    if ((row.candidate.certain & row.reference.certain) != all_columns) return false;
    std::ranges::copy(row.candidate.bin, &strip.candidate.bin[first]);
    std::ranges::copy(row.reference.bin, &strip.reference.bin[first]);
    strip.open[first / Strip::chunk] = 0;
    return true;
}

bool Presort::sort_some_laws(const LawsOfBoth& laws, const KnownLargest& largest, std::size_t first,
                             Strip& strip) {
    const auto [same, bare] = agreement(strip, first);
    std::array<Share, most_laws> shares;
    std::size_t count = 0;
    for (ColumnMask rest = same & ~bare; rest != 0; ++count) {
        const std::uint32_t law = strip.candidate.law[first + std::size_t(std::countr_zero(rest))];
        if (law == 0 || count == most_laws) return false;
        shares[count] = {law, rest & equal_laws(&strip.candidate.law[first], law)};
        rest &= ~shares[count].pixels;
    }
    TileRowOf<std::int32_t> our_bin, their_bin;
    our_bin.fill(Strip::uncounted), their_bin.fill(Strip::uncounted);
    for (const auto& [law, pixels] : std::span(shares).first(count)) {
        const DepthEstimate& triangle = estimate_by(laws, law);
        if (!triangle.is_usable) return false;
        EstimatedRow row;
        estimate(triangle, projection_, {strip.x + int(first), strip.y}, &strip.candidate.camera_depth[first],
                 &strip.reference.camera_depth[first], largest, row);
        if ((pixels & ~(row.candidate.certain & row.reference.certain)) != 0) return false;
        take(row.candidate.bin, pixels, our_bin);
        take(row.reference.bin, pixels, their_bin);
    }
    std::ranges::copy(our_bin, &strip.candidate.bin[first]);
    std::ranges::copy(their_bin, &strip.reference.bin[first]);
    strip.open[first / Strip::chunk] = ~same & all_columns;
    return true;
}

}  // namespace zproof
