#include "compare/depth_law.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include "compare/four.h"
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

/// Where a law's relative error is the same everywhere, its sum was compounded with the law.
enum class Relative { everywhere, by_nearness };

Four relative_error(const Law& t, const Four& here, Relative relative) {
    if (relative == Relative::everywhere) return t.relative;
    const Four varying = t.depth_factor + t.plane_offset / here;
    const Four sum = t.plane_offset == 0.0 ? t.depth_factor : varying;
    const Four compounded = sum / (1.0 - sum);
    return sum < 1.0 ? compounded : everywhere<Four>(infinite);
}

/// Depths held against their laws. The bound's end on the depth's own side of the truth is worked out, for
/// the ratio is taken there. In place of the other end stands the truth itself: rounding is monotone, so
/// nearness + s is not below nearness, nor is anything that follows from them, and a depth that the narrower
/// interval holds is held by the bound. What it does not hold may still be lawful, and is unsettled.
template <class Projected>
Four ratio_of(const Law& t, const Spot& spot, const Four& z, Relative kind) {
    const Four reach = (t.base + t.per * spot.here) * t.amplification;
    const Four shift = smaller(t.most, reach) * t.gradient + t.nearness_error;
    const Four truth = held_between(spot.depth, t.nearest, t.farthest);
    const auto is_near = z < truth;
    const Four own_end =
        held_between(Projected::depth(spot.nearness + (is_near ? shift : -shift)), t.nearest, t.farthest);
    const Four nearest = is_near ? own_end : truth, farthest = is_near ? truth : own_end;
    const Four relative = relative_error(t, spot.here, kind);
    const Four low = nearest - absolute(nearest) * relative - t.absolute;
    const Four high = farthest + absolute(farthest) * relative + t.absolute;
    const Four margin = Projected::margin(t.own_error, z), rounding = 8 * unit_roundoff_float64 * z;
    const auto holds = (relative < infinite) & (truth + shift < infinite) & (z >= 0.0) &
                       (low + margin + rounding <= z) & (z <= high - margin - rounding);
    const Four error = absolute(z - truth), room = is_near ? truth - low : high - truth;
    const Four share = error / room, none{};
    return holds ? (error > 0.0 ? share : none) : everywhere<Four>(unsettled);
}

constexpr std::size_t fields = sizeof(DepthLaw) / sizeof(double);
static_assert(fields % 2 == 0 && sizeof(Law) == fields * sizeof(Four));

/// Four laws side by side, two numbers of each at a time.
Law side_by_side(const std::vector<DepthLaw>& laws, const std::uint32_t* which) {
    using Two = double __attribute__((vector_size(16)));
    using Pairs = std::array<Two, fields / 2>;
    const DepthLaw *a = &laws[which[0]], *b = &laws[which[1]], *c = &laws[which[2]], *d = &laws[which[3]];
    const auto pair = [](const DepthLaw* law, std::size_t i) {
        Two two;
        std::memcpy(&two, reinterpret_cast<const char*>(law) + i * sizeof two, sizeof two);
        return two;
    };
    std::array<Four, fields> all;
    for (std::size_t i = 0; i < std::tuple_size_v<Pairs>; ++i) {
        const Four first = __builtin_shufflevector(pair(a, i), pair(c, i), 0, 1, 2, 3);
        const Four second = __builtin_shufflevector(pair(b, i), pair(d, i), 0, 1, 2, 3);
        all[2 * i] = __builtin_shufflevector(first, second, 0, 4, 2, 6);
        all[2 * i + 1] = __builtin_shufflevector(first, second, 1, 5, 3, 7);
    }
    return std::bit_cast<Law>(all);
}

/// The laws of four pixels. Where one triangle fills them they are often those of the four before.
class LatestLaw {
  public:
    explicit LatestLaw(const std::vector<DepthLaw>& laws) : laws_(laws) {}

    void turn_to(const std::uint32_t* which) {
        const bool is_one = ((which[0] ^ which[1]) | (which[0] ^ which[2]) | (which[0] ^ which[3])) == 0;
        if (is_one && is_one_ && which[0] == which_) return;
        law_ = side_by_side(laws_, which);
        is_one_ = is_one;
        which_ = which[0];
        const auto varies = law_.plane_offset != 0.0;
        kind_ = (varies[0] | varies[1] | varies[2] | varies[3]) != 0 ? Relative::by_nearness
                                                                     : Relative::everywhere;
    }
    /// Are all four bare?
    bool is_of_nothing() const { return is_one_ && which_ == 0; }
    const Law& law() const { return law_; }
    Relative kind() const { return kind_; }

  private:
    const std::vector<DepthLaw>& laws_;
    bool is_one_ = false;
    std::uint32_t which_ = 0;
    Law law_;
    Relative kind_ = Relative::everywhere;
};

Four depths_at(const Strip::Side& side, std::size_t first) {
    using Floats = float __attribute__((vector_size(16)));
    Floats depth;
    std::memcpy(&depth, &side.camera_depth[first], sizeof depth);
    return __builtin_convertvector(depth, Four);
}

void put(const Four& ratio, Strip::Side& side, std::size_t first) {
    std::memcpy(&side.ratio[first], &ratio, sizeof ratio);
}

template <class Projected>
void hold_strip(const LawsOfBoth& laws, Strip& strip) {
    LatestLaw candidate(laws.candidate), reference(laws.reference);
    for (std::size_t first = 0; first < Strip::width; first += four_count) {
        const std::uint32_t *ours = &strip.candidate.law[first], *theirs = &strip.reference.law[first];
        candidate.turn_to(ours);
        reference.turn_to(theirs);
        if (candidate.is_of_nothing() && reference.is_of_nothing()) {
            put(everywhere<Four>(unsettled), strip.candidate, first);
            put(everywhere<Four>(unsettled), strip.reference, first);
            continue;
        }
        const double x = strip.x + int(first);
        const Four at{x, x + 1, x + 2, x + 3};
        const Spot spot = spot_of<Projected>(candidate.law(), at, strip.y);
        const bool is_shared = std::equal(ours, ours + four_count, theirs);
        const Spot other = is_shared ? spot : spot_of<Projected>(reference.law(), at, strip.y);
        put(ratio_of<Projected>(candidate.law(), spot, depths_at(strip.candidate, first), candidate.kind()),
            strip.candidate, first);
        put(ratio_of<Projected>(reference.law(), other, depths_at(strip.reference, first), reference.kind()),
            strip.reference, first);
    }
}

constexpr std::size_t together = 8;
static_assert(Strip::width % together == 0 && std::tuple_size_v<Largest> == together);

/// 0 to 20.
[[gnu::always_inline]] inline std::int32_t bin_of(double ratio) {
    const double scaled = ratio * 20;
    return std::int32_t(scaled < 20 ? scaled : 20);
}

}  // namespace

/// Compiled once per instruction set, with everything that they call. No bit depends on which runs:
/// contraction is off, and every pixel's operations keep their order.
[[gnu::flatten, gnu::target_clones("default", "avx2")]] void hold_perspective(const LawsOfBoth& laws,
                                                                              Strip& strip) {
    hold_strip<Perspective>(laws, strip);
}

[[gnu::flatten, gnu::target_clones("default", "avx2")]] void hold_parallel(const LawsOfBoth& laws,
                                                                           Strip& strip) {
    hold_strip<Parallel>(laws, strip);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void sort_out(Strip& strip, Largest& candidate,
                                                                   Largest& reference) {
    constexpr float none = std::numeric_limits<float>::infinity();
    Strip::Side &ours = strip.candidate, &theirs = strip.reference;
    Largest most = candidate, most_of_theirs = reference;
    for (std::size_t first = 0; first < Strip::width; first += together)
        for (std::size_t lane = 0; lane < together; ++lane) {
            const std::size_t i = first + lane;
            const double a = ours.ratio[i], b = theirs.ratio[i];
            const bool agree = ours.primitive[i] == theirs.primitive[i];
            const bool is_counted = agree & (a >= 0) & (b >= 0);
            const bool is_bare = agree & (ours.primitive[i] == PrimitiveId::none) &
                                 (ours.camera_depth[i] == none) & (theirs.camera_depth[i] == none);
            ours.bin[i] = is_counted ? bin_of(a) : Strip::uncounted;
            theirs.bin[i] = is_counted ? bin_of(b) : Strip::uncounted;
            strip.is_open[i] = !(is_counted | is_bare);
            most[lane] = is_counted & (a > most[lane]) ? a : most[lane];
            most_of_theirs[lane] = is_counted & (b > most_of_theirs[lane]) ? b : most_of_theirs[lane];
        }
    candidate = most;
    reference = most_of_theirs;
}

}  // namespace zproof
