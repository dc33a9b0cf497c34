#include "reports/depth_colours.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "reports/id_colours.h"
#include "reports/rgb_words.h"
#include "reports/viridis.h"

namespace zproof {

namespace {

constexpr std::uint32_t largest = 0x7F7FFFFF;  ///< the bits of the largest finite float
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t buckets = 4096;
constexpr std::uint32_t no_colour = none;

/// The range of the finite positive depths; `none` and 0 where there are none.
DepthRange range_in(std::span<const float> depths) {
    std::uint32_t low = none, high = 0;
    for (const float depth : depths) {
        const auto bits = std::bit_cast<std::uint32_t>(depth);
        const bool is_depth = bits - 1 < largest;
        low = std::min(low, is_depth ? bits : none);
        high = std::max(high, is_depth ? bits : 0);
    }
    return {low, high};
}

/// All bits or none.
inline std::uint32_t all_if(bool is_so) { return 0u - std::uint32_t(is_so); }

float depth_of(std::uint32_t bits) { return std::bit_cast<float>(bits); }

}  // namespace

DepthRange range_of(const Plane<float>& depths) {
    const auto wider = [](const DepthRange& a, const DepthRange& b) {
        return DepthRange{std::min(a.nearest, b.nearest), std::max(a.farthest, b.farthest)};
    };
    using Rows = tbb::blocked_range<int>;
    const DepthRange range = tbb::parallel_reduce(
        Rows(0, depths.size().height, 64), DepthRange{none, 0},
        [&](const Rows& rows, DepthRange so_far) {
            for (int y = rows.begin(); y < rows.end(); ++y) so_far = wider(so_far, range_in(depths.row(y)));
            return so_far;
        },
        wider);
    return range.farthest > 0 ? range : DepthRange{};
}

DepthColours::DepthColours(const DepthRange& range) : range_(range) {
    if (range.farthest == 0) {
        const std::uint32_t colour = word_of(no_depth_colour);
        buckets_.push_back({colour, colour, none, 0});
        return;
    }
    log_near_ = std::log(depth_of(range.nearest)), log_far_ = std::log(depth_of(range.farthest));
    steps_.push_back({range.nearest, by_formula(depth_of(range.nearest))});
    find_steps(place_of(range.nearest), place_of(range.farthest));
    steps_.insert(steps_.end(), 2, {none, {}});
    const std::uint32_t reach = range.farthest - range.nearest;
    shift_ = std::max(0, int(std::bit_width(reach)) - int(std::bit_width(buckets - 1)));
    std::uint32_t step = 0;
    for (std::uint32_t bucket = 0; bucket <= reach >> shift_; ++bucket) {
        const std::uint32_t least = range.nearest + (bucket << shift_);
        while (steps_[step + 1].bits <= least) ++step;
        buckets_.push_back(bucket_from(least, step));
    }
}

/// `step` is the one that the bucket's least depth, `bits`, is in.
auto DepthColours::bucket_from(std::uint32_t bits, std::uint32_t step) const -> Bucket {
    const std::uint32_t change = steps_[step + 1].bits, bucket_width = 1u << shift_;
    const bool has_one = change - bits >= bucket_width;
    const bool has_two = !has_one && steps_[step + 2].bits - bits >= bucket_width;
    const std::uint32_t before = word_of(steps_[step].colour), after = word_of(steps_[step + 1].colour);
    if (has_one) return {before, before, change, step};
    return has_two ? Bucket{before, after, change, step} : Bucket{no_colour, no_colour, change, step};
}

double DepthColours::share_of(std::uint32_t bits) const {
    const double span = log_far_ - log_near_;
    return span > 0 ? (log_far_ - std::log(depth_of(bits))) / span : 0.7;
}

Rgb8 DepthColours::by_formula(float depth) const {
    return viridis(share_of(std::bit_cast<std::uint32_t>(depth)));
}

auto DepthColours::place_of(std::uint32_t bits) const -> RasterPosition {
    const double share = share_of(bits);
    return {bits, viridis(share), viridis_piece(share)};
}

/// Appends the steps in (low, high]. Every operation of the formula is monotone in depth, the logarithm too:
/// neighbouring floats lie 2^-24 apart, relatively, and the logarithms of what is between them far more than
/// its error of 2^-52 times its value. So is each channel within one piece of viridis, and where both ends of
/// an interval have one colour in one piece, so has all between.
void DepthColours::find_steps(const RasterPosition& low, const RasterPosition& high) {
    if (low.colour == high.colour && low.piece == high.piece) return;
    if (high.bits - low.bits == 1) {
        if (!(low.colour == high.colour)) steps_.push_back({high.bits, high.colour});
        return;
    }
    const RasterPosition middle = place_of(low.bits + (high.bits - low.bits) / 2);
    find_steps(low, middle);
    find_steps(middle, high);
}

auto DepthColours::step_of(std::uint32_t bits) const -> const Step& {
    assert(bits >= range_.nearest && bits <= range_.farthest);
    std::size_t step = buckets_.first[(bits - range_.nearest) >> shift_];
    while (steps_[step + 1].bits <= bits) ++step;
    return steps_[step];
}

Rgb8 DepthColours::operator()(float depth) const {
    return step_of(std::bit_cast<std::uint32_t>(depth)).colour;
}

void DepthColours::Buckets::push_back(const Bucket& bucket) {
    before.push_back(bucket.before), after.push_back(bucket.after);
    change.push_back(bucket.change), first.push_back(bucket.first);
}

/// No colour where the steps must be asked; returns the greatest word. No branches, so that neighbours are
/// looked up side by side.
std::uint32_t DepthColours::look_up(std::span<const float> depths, std::uint32_t* __restrict words) const {
    constexpr auto background = std::bit_cast<std::uint32_t>(background_depth);
    constexpr std::uint32_t far_off = word_of(background_colour), no_depth = word_of(no_depth_colour);
    const std::uint32_t *before = buckets_.before.data(), *after = buckets_.after.data(),
                        *change = buckets_.change.data();
    const std::uint32_t nearest = range_.nearest, reach = range_.farthest - nearest;
    const float* const from = depths.data();
    const std::size_t count = depths.size();
    const int shift = shift_;
    std::uint32_t greatest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto bits = std::bit_cast<std::uint32_t>(from[i]);
        const std::uint32_t beyond = bits - nearest, is_within = all_if(beyond <= reach);
        const auto bucket = std::int32_t((beyond >> shift) & is_within);
        const std::uint32_t is_after = all_if(bits >= change[bucket]);
        const std::uint32_t within = (before[bucket] & ~is_after) | (after[bucket] & is_after);
        const std::uint32_t is_background = all_if(bits == background);
        const std::uint32_t without = (far_off & is_background) | (no_depth & ~is_background);
        words[i] = (within & is_within) | (without & ~is_within);
        greatest = std::max(greatest, words[i]);
    }
    return greatest;
}

void DepthColours::colour(std::span<const float> depths, std::span<Rgb8> pixels) const {
    std::array<std::uint32_t, 256> words;
    for (std::size_t first = 0; first < depths.size(); first += words.size()) {
        const auto some = depths.subspan(first, std::min(words.size(), depths.size() - first));
        const bool is_all = look_up(some, words.data()) != no_colour;
        for (std::size_t i = 0; !is_all && i < some.size(); ++i)
            if (words[i] == no_colour) words[i] = word_of((*this)(some[i]));
        store(std::span(words).first(some.size()), pixels.subspan(first, some.size()));
    }
}

}  // namespace zproof
