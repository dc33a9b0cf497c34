#include "texture/coverage.h"

#include <algorithm>
#include <cmath>

namespace zproof::texture {

namespace {

/// What [low, high] within [0, size] covers, times scale: three runs, less one for each end on a texel's
/// edge.
void cover_within(double low, double high, double scale, Parts<Run>& runs) {
    const int begin = int(std::ceil(low)), end = int(high);  // the whole texels
    if (begin > end) {
        runs.add({end, begin, scale * (high - low)});
        return;
    }
    if (begin > low) runs.add({begin - 1, begin, scale * (begin - low)});
    if (end > begin) runs.add({begin, end, scale});
    if (high > end) runs.add({end, end + 1, scale * (high - end)});
}

Parts<Run> covered_clamped(const Extent& extent, int size) {
    const double scale = 1 / (extent.high - extent.low);
    const double before = std::min(extent.high, 0.0) - std::min(extent.low, 0.0),
                 behind = std::max(extent.high, double(size)) - std::max(extent.low, double(size));
    Parts<Run> runs;
    if (before > 0) runs.add({0, 1, scale * before});
    const double low = std::clamp(extent.low, 0.0, double(size)),
                 high = std::clamp(extent.high, 0.0, double(size));
    cover_within(low, high, scale, runs);
    if (behind > 0) runs.add({size - 1, size, scale * behind});
    return runs;
}

/// A copy of the axis among all that repetition or mirrors put side by side.
struct Tile {
    double index = 0;
    Wrap wrap{};
    int size = 0;

    bool is_mirrored() const { return wrap == Wrap::mirrored_repeat && std::fmod(index, 2) != 0; }
    double begin() const { return index * size; }
    /// [low, high] within this tile, in the tile's own texels.
    void cover(double low, double high, double scale, Parts<Run>& runs) const {
        // floor(low / size) may be one too high by rounding; and where coordinates are huge, all is rounding.
        const double from = std::clamp(low - begin(), 0.0, double(size)),
                     to = std::clamp(high - begin(), 0.0, double(size));
        if (is_mirrored())
            cover_within(size - to, size - from, scale, runs);
        else
            cover_within(from, to, scale, runs);
    }
};

/// An end of an interval: its place in the first copy of the axis, and how often the whole axis lies below
/// it.
struct End {
    double wholes = 0, place = 0;
    double sign = 1;  ///< of the place's prefix sum
};

End end_at(double coordinate, Wrap wrap, int size) {
    const double tile = std::floor(coordinate / size),
                 within = std::clamp(coordinate - tile * size, 0.0, double(size));
    if (wrap == Wrap::mirrored_repeat && std::fmod(tile, 2) != 0) return {tile + 1, size - within, -1};
    return {tile, within, 1};
}

/// The prefix sum at a place of [0, size], between its two neighbours.
void interpolate(double place, double weight, int size, Parts<Prefix>& sums) {
    const int low = std::min(int(place), size - 1);
    if (low > 0) sums.add({low, weight * (low + 1 - place)});
    sums.add({low + 1, weight * (place - low)});
}

/// Beyond the ends the prefix sum goes on as a straight line, since the last texel does.
void extrapolate(double coordinate, double weight, int size, Parts<Prefix>& sums) {
    const double low = std::clamp(std::floor(coordinate), 0.0, double(size - 1));
    if (low > 0) sums.add({int(low), weight * (low + 1 - coordinate)});
    sums.add({int(low) + 1, weight * (coordinate - low)});
}

}  // namespace

Parts<Run> covered(const Extent& extent, Wrap wrap, int size) {
    if (wrap == Wrap::clamp_to_edge) return covered_clamped(extent, size);
    const double scale = 1 / (extent.high - extent.low);
    const Tile first{std::floor(extent.low / size), wrap, size},
        last{std::floor(extent.high / size), wrap, size};
    Parts<Run> runs;
    first.cover(extent.low, std::min(extent.high, first.begin() + size), scale, runs);
    if (last.index <= first.index) return runs;
    const double whole = last.index - first.index - 1;
    if (whole > 0) runs.add({0, size, scale * whole});
    last.cover(last.begin(), extent.high, scale, runs);
    return runs;
}

Parts<Prefix> prefixes(const Extent& extent, Wrap wrap, int size) {
    const double scale = 1 / (extent.high - extent.low);
    Parts<Prefix> sums;
    if (wrap == Wrap::clamp_to_edge) {
        extrapolate(extent.high, scale, size, sums);
        extrapolate(extent.low, -scale, size, sums);
        return sums;
    }
    const End high = end_at(extent.high, wrap, size), low = end_at(extent.low, wrap, size);
    interpolate(high.place, scale * high.sign, size, sums);
    interpolate(low.place, -scale * low.sign, size, sums);
    if (high.wholes != low.wholes) sums.add({size, scale * (high.wholes - low.wholes)});
    return sums;
}

}  // namespace zproof::texture
