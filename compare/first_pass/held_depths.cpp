#include "compare/first_pass/held_depths.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "compare/bounds/depth_terms.h"
#include "compare/bounds/side_by_side.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Law = DepthLawOf<Four>;

/// What the projections differ in: the depth of a nearness, and what our own rounding of the nearness comes
/// to at depth z. Divisions come first and what they give is chosen afterwards, so that there are no
/// branches.
struct Perspective {
    static Four depth(const Four& nearness) {
        const Four reciprocal = 1.0 / nearness;
        return nearness > 0.0 ? reciprocal : everywhere<Four>(infinite);
    }
    static Four margin(const Four& own_error, const Four& z) { return 2.0 * own_error * z * z; }
};
struct Parallel {
    static Four depth(const Four& nearness) { return -nearness; }
    static Four margin(const Four& own_error, const Four&) { return own_error; }
};

/// What both renderers share at four pixels.
struct Spot {
    Four nearness;
    Four here;  ///< nearness, within the corners'
    Four depth;
};

template <class Projected>
Spot spot_of(const Law& law, const Four& x, int y) {
    const Four nearness = law.nearness_per_x * x + law.nearness_per_y * double(y) + law.nearness_offset;
    return {nearness, held_between(nearness, law.least, law.highest), Projected::depth(nearness)};
}

/// What displacement does to nearness.
Four shift_of(const Law& t, const Spot& spot) {
    const Four reach = (t.base + t.per * spot.here) * t.amplification;
    return smaller(t.most, reach) * t.gradient + t.nearness_error;
}

Four within_corners(const Law& t, const Four& depth) { return held_between(depth, t.nearest, t.farthest); }

/// The depths that a displaced plane has, before rounding.
struct Ends {
    Four nearest, truth, farthest;
};

template <class Projected>
Ends ends_of(const Law& t, const Spot& spot) {
    const Four shift = shift_of(t, spot);
    return {within_corners(t, Projected::depth(spot.nearness + shift)), within_corners(t, spot.depth),
            within_corners(t, Projected::depth(spot.nearness - shift))};
}

/// Where a law's relative error is the same everywhere, its sum was compounded with the law.
enum class Relative { everywhere, by_nearness };

Relative relative_of(const Law& t) {
    const auto varies = t.plane_offset != 0.0;
    return (varies[0] | varies[1] | varies[2] | varies[3]) != 0 ? Relative::by_nearness
                                                                : Relative::everywhere;
}

Four relative_error(const Law& t, const Four& here, Relative relative) {
    if (relative == Relative::everywhere) return t.relative;
    const Four varying = t.depth_factor + t.plane_offset / here;
    return compounded(t.plane_offset == 0.0 ? t.depth_factor : varying);
}

/// A depth's bound, and its error over that.
struct Held {
    Four low, truth, high, ratio;
};

template <class Projected>
Held held(const Law& t, const Ends& ends, const Four& relative, const Four& z) {
    const Four low = ends.nearest - absolute(ends.nearest) * relative - t.absolute;
    const Four high = ends.farthest + absolute(ends.farthest) * relative + t.absolute;
    const Four margin = Projected::margin(t.own_error, z), rounding = 8 * unit_roundoff_float64 * z;
    const auto holds = (relative < infinite) & (ends.truth < infinite) & (z >= 0.0) &
                       (low + margin + rounding <= z) & (z <= high - margin - rounding);
    const Four error = absolute(z - ends.truth);
    const Four room = z < ends.truth ? ends.truth - low : high - ends.truth;
    const Four share = error / room, none{};
    return {low, ends.truth, high, holds ? (error > 0.0 ? share : none) : everywhere<Four>(unsettled)};
}

Four four_at(const float* depth) {
    using Floats = float __attribute__((vector_size(16)));
    Floats floats;
    std::memcpy(&floats, depth, sizeof floats);
    return __builtin_convertvector(floats, Four);
}

/// The four from x on.
Four from_on(double x) { return Four{x, x + 1, x + 2, x + 3}; }

/// The laws of four pixels. Where one triangle fills them they are often those of the four before.
class LatestLaw {
  public:
    explicit LatestLaw(const std::vector<DepthLaw>& laws) : laws_(laws) {
        put_side_by_side<DepthLawOf>({&laws[0], &laws[0], &laws[0], &laws[0]}, law_);
    }

    void turn_to(const std::uint32_t* which) {
        const bool is_one = ((which[0] ^ which[1]) | (which[0] ^ which[2]) | (which[0] ^ which[3])) == 0;
        if (is_one && is_one_ && which[0] == which_) return;
        put_side_by_side<DepthLawOf>({&laws_[which[0]], &laws_[which[1]], &laws_[which[2]], &laws_[which[3]]},
                                     law_);
        is_one_ = is_one;
        which_ = which[0];
        kind_ = relative_of(law_);
    }
    /// Is none of the four held against anything?
    bool is_of_nothing() const { return is_one_ && which_ == 0; }

    template <class Projected>
    Spot spot(double x, int y) const {
        return spot_of<Projected>(law_, from_on(x), y);
    }
    template <class Projected>
    void hold(const Spot& spot, const float* camera_depth, double* ratio) const {
        const Four relative = relative_error(law_, spot.here, kind_);
        const Held four =
            held<Projected>(law_, ends_of<Projected>(law_, spot), relative, four_at(camera_depth));
        std::memcpy(ratio, &four.ratio, sizeof four.ratio);
    }

  private:
    Law law_;
    const std::vector<DepthLaw>& laws_;
    std::uint32_t which_ = 0;
    Relative kind_ = Relative::everywhere;
    bool is_one_ = true;
};

template <class Projected>
void hold_strip(const LawsOfBoth& laws, const Strip& strip, const LawsAlong& along, SortedStrip& all) {
    LatestLaw candidate(laws.candidate), reference(laws.reference);
    for (std::size_t first = 0; first < Strip::width; first += four_count) {
        if ((all.sorted >> first / Strip::chunk & 1) != 0) continue;
        const std::uint32_t *ours = &along.candidate[first], *theirs = &along.reference[first];
        candidate.turn_to(ours);
        reference.turn_to(theirs);
        if (candidate.is_of_nothing() && reference.is_of_nothing()) {
            std::fill_n(&all.ratio.candidate[first], four_count, unsettled);
            std::fill_n(&all.ratio.reference[first], four_count, unsettled);
            continue;
        }
        const double x = strip.x + int(first);
        const Spot spot = candidate.spot<Projected>(x, strip.y);
        const bool is_shared = std::equal(ours, ours + four_count, theirs);
        const Spot other = is_shared ? spot : reference.spot<Projected>(x, strip.y);
        candidate.hold<Projected>(spot, &strip.candidate.camera_depth[first], &all.ratio.candidate[first]);
        reference.hold<Projected>(other, &strip.reference.camera_depth[first], &all.ratio.reference[first]);
    }
}

template <class Projected>
DepthRow hold_row(const DepthLaw& law, const RowPlace& row, const TileRowOf<float>& camera_depth) {
    Law four;
    put_side_by_side<DepthLawOf>({&law, &law, &law, &law}, four);
    const Relative kind = relative_of(four);
    DepthRow all;
    for (std::size_t i = 0; i < tile_columns; i += four_count) {
        const Spot spot = spot_of<Projected>(four, from_on(row.left + int(i)), row.y);
        const Held one = held<Projected>(four, ends_of<Projected>(four, spot),
                                         relative_error(four, spot.here, kind), four_at(&camera_depth[i]));
        std::memcpy(&all.low[i], &one.low, sizeof one.low);
        std::memcpy(&all.truth[i], &one.truth, sizeof one.truth);
        std::memcpy(&all.high[i], &one.high, sizeof one.high);
        std::memcpy(&all.ratio[i], &one.ratio, sizeof one.ratio);
    }
    return all;
}

constexpr std::size_t together = 8;
static_assert(Strip::width % together == 0 && std::tuple_size_v<Largest> == together);

}  // namespace

/// Compiled once per instruction set, with everything that they call. No bit depends on which runs:
/// contraction is off, and every pixel's operations keep their order.
[[gnu::flatten, gnu::target_clones("default", "avx2")]] void hold_perspective(const LawsOfBoth& laws,
                                                                              const Strip& strip,
                                                                              const LawsAlong& along,
                                                                              SortedStrip& held) {
    hold_strip<Perspective>(laws, strip, along, held);
}

[[gnu::flatten, gnu::target_clones("default", "avx2")]] void hold_parallel(const LawsOfBoth& laws,
                                                                           const Strip& strip,
                                                                           const LawsAlong& along,
                                                                           SortedStrip& held) {
    hold_strip<Parallel>(laws, strip, along, held);
}

[[gnu::flatten, gnu::target_clones("default", "avx2")]] DepthRow depths_in_row(
    const DepthLaw& law, Projection projection, const RowPlace& row, const TileRowOf<float>& camera_depth) {
    return projection == Projection::perspective ? hold_row<Perspective>(law, row, camera_depth)
                                                 : hold_row<Parallel>(law, row, camera_depth);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void sort_out(const Strip& strip, SortedStrip& all,
                                                                   Largest& candidate, Largest& reference) {
    constexpr float none = std::numeric_limits<float>::infinity();
    const Strip::Side &ours = strip.candidate, &theirs = strip.reference;
    Largest most = candidate, most_of_theirs = reference;
    for (std::size_t chunk = 0; chunk < all.open.size(); ++chunk) {
        if ((all.sorted >> chunk & 1) != 0) continue;
        TileRowOf<std::uint32_t> what;  // 1: open; and from bit 16 on the same for what is lawful
        for (std::size_t first = 0; first < Strip::chunk; first += together)
            for (std::size_t lane = 0; lane < together; ++lane) {
                const std::size_t i = chunk * Strip::chunk + first + lane;
                const double a = all.ratio.candidate[i], b = all.ratio.reference[i];
                const float our_depth = ours.camera_depth[i], their_depth = theirs.camera_depth[i];
                const PrimitiveId shown = ours.primitive[i];
                const bool agree = shown == theirs.primitive[i];
                const bool is_counted = agree & (a >= 0) & (b >= 0);
                const bool is_bare =
                    agree & (shown == PrimitiveId::none) & (our_depth == none) & (their_depth == none);
                const std::uint32_t is_open = !(is_counted | is_bare), is_lawful = (a >= 0) & (b >= 0);
                what[first + lane] = is_open | (is_open & is_lawful) << 16;
                most[lane] = (is_counted & (a > most[lane])) ? a : most[lane];
                most_of_theirs[lane] = (is_counted & (b > most_of_theirs[lane])) ? b : most_of_theirs[lane];
            }
        std::uint32_t masks = 0;
        for (std::size_t i = 0; i < Strip::chunk; ++i) masks |= what[i] << i;
        all.open[chunk] = masks & all_columns;
        all.lawful[chunk] = masks >> 16;
    }
    candidate = most;
    reference = most_of_theirs;
}

}  // namespace zproof
