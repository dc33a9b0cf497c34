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

/// Of the finite positive ones; `none` and 0 where there are none.
[[gnu::target_clones("default", "avx2", "avx512f")]] DepthRange range_in(std::span<const float> depths) {
    std::uint32_t low = none, high = 0;
    for (const float depth : depths) {
        const auto bits = std::bit_cast<std::uint32_t>(depth);
        const bool is_depth = bits - 1 < largest;
        low = std::min(low, is_depth ? bits : none);
        high = std::max(high, is_depth ? bits : 0);
    }
    return {low, high};
}

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
    if (range.farthest == 0) return;
    log_near_ = std::log(depth_of(range.nearest)), log_far_ = std::log(depth_of(range.farthest));
    steps_.push_back({range.nearest, by_formula(depth_of(range.nearest))});
    find_steps(range.nearest, range.farthest);
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
    const std::uint32_t change = steps_[step + 1].bits, width = 1u << shift_;
    const bool has_one = change - bits >= width;
    const bool has_two = !has_one && steps_[step + 2].bits - bits >= width;
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

/// Appends the steps in (low, high]. Every operation of the formula is monotone in depth, the logarithm too:
/// neighbouring floats lie 2^-24 apart, relatively, and the logarithms of what is between them far more than
/// its error of 2^-52 times its value. So is each channel within one piece of viridis, and where both ends of
/// an interval have one colour in one piece, so has all between.
void DepthColours::find_steps(std::uint32_t low, std::uint32_t high) {
    const double t_low = share_of(low), t_high = share_of(high);
    if (viridis(t_low) == viridis(t_high) && viridis_piece(t_low) == viridis_piece(t_high)) return;
    if (high - low == 1) {
        if (!(viridis(t_low) == viridis(t_high))) steps_.push_back({high, viridis(t_high)});
        return;
    }
    const std::uint32_t middle = low + (high - low) / 2;
    find_steps(low, middle);
    find_steps(middle, high);
}

auto DepthColours::step_of(std::uint32_t bits) const -> const Step& {
    assert(bits >= range_.nearest && bits <= range_.farthest);
    std::size_t step = buckets_[(bits - range_.nearest) >> shift_].first;
    while (steps_[step + 1].bits <= bits) ++step;
    return steps_[step];
}

Rgb8 DepthColours::operator()(float depth) const {
    return step_of(std::bit_cast<std::uint32_t>(depth)).colour;
}

std::uint32_t DepthColours::word_at(float depth) const {
    const auto bits = std::bit_cast<std::uint32_t>(depth);
    const std::uint32_t beyond = bits - range_.nearest;
    if (beyond > range_.farthest - range_.nearest || buckets_.empty())
        return word_of(depth == background_depth ? background_colour : no_depth_colour);
    const Bucket& bucket = buckets_[beyond >> shift_];
    const std::uint32_t word = bits < bucket.change ? bucket.before : bucket.after;
    return word == no_colour ? word_of(step_of(bits).colour) : word;
}

void DepthColours::colour(std::span<const float> depths, std::span<Rgb8> pixels) const {
    std::array<std::uint32_t, 256> words;
    for (std::size_t first = 0; first < depths.size(); first += words.size()) {
        const std::size_t count = std::min(words.size(), depths.size() - first);
        for (std::size_t i = 0; i < count; ++i) words[i] = word_at(depths[first + i]);
        store(std::span(words).first(count), pixels.subspan(first, count));
    }
}

}  // namespace zproof
