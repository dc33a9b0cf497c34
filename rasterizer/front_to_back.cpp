#include "rasterizer/front_to_back.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace zproof::rasterizer {
namespace {

/// Floats in their order, -infinity to infinity, about as fine everywhere in relation to their size.
std::uint32_t in_whole_numbers(float value) {
    constexpr std::uint32_t sign = 0x8000'0000;
    const auto bits = std::bit_cast<std::uint32_t>(value);
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

float nearest_of(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c) {
    return nearest_pixel(a.inverse_depth, b.inverse_depth, c.inverse_depth);
}

template <class Visit>
void for_each_in_parallel(std::size_t count, const Visit& visit) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>{0, count, 4096}, [&](const auto& some) {
        for (std::size_t i = some.begin(); i < some.end(); ++i) visit(i);
    });
}

constexpr int most_step_bits = 8;

}  // namespace

bool front_to_back_pays(const BinTally& tally) {
    const double layers = double(tally.cover_px) / double(std::max<std::uint64_t>(tally.reached_px, 1));
    const double px_per_triangle = double(tally.cover_px) / double(std::max<std::uint64_t>(tally.set_up, 1));
    return layers >= 1.75 && layers * px_per_triangle >= 32;
}

void FrontToBack::fill(const TileBins& bins) {
    const Triangles& t = bins.triangles();
    const std::span<const SnappedPiece> pieces = bins.pieces();
    nearest_.resize(t.length + pieces.size());
    for_each_in_parallel(t.length, [&](std::size_t i) {
        const glm::uvec3& v = t.corners[i];
        nearest_[i] = nearest_of(t.vertices[v.x], t.vertices[v.y], t.vertices[v.z]);
    });
    for_each_in_parallel(pieces.size(), [&](std::size_t i) {
        const SnappedVertex(&v)[3] = pieces[i].vertex;
        nearest_[t.length + i] = nearest_of(v[0], v[1], v[2]);
    });
}

TileEntries FrontToBack::ordered(std::span<const std::uint32_t> entries) {
    Ordered& ordered = ordered_.local();
    put_in_order(entries, ordered);
    find_nearest_left(ordered);
    return {ordered.entries, Ties::least_id, ordered.nearest_left.data()};
}

/// Steps are counted, then each entry is put where its step has come to.
void FrontToBack::put_in_order(std::span<const std::uint32_t> entries, Ordered& ordered) const {
    ordered.distance.resize(entries.size());
    ordered.entries.resize(entries.size());
    std::uint32_t least = ~std::uint32_t{0}, most = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::uint32_t distance = ~in_whole_numbers(nearest(entries[i]));
        ordered.distance[i] = distance;
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    const int step_bits = std::min(int(std::bit_width(entries.size())) + 1, most_step_bits);
    const int shift = std::max(0, int(std::bit_width(most - least)) - step_bits);
    const auto step_of = [&](std::size_t i) { return (ordered.distance[i] - least) >> shift; };
    std::array<std::uint32_t, 1 << most_step_bits> room;
    const auto next = std::span(room).first(std::size_t{1} << step_bits);
    std::ranges::fill(next, 0);
    for (std::size_t i = 0; i < entries.size(); ++i) ++next[step_of(i)];
    std::uint32_t first = 0;
    for (std::uint32_t& of_step : next) first += std::exchange(of_step, first);
    for (std::size_t i = 0; i < entries.size(); ++i) ordered.entries[next[step_of(i)]++] = entries[i];
}

void FrontToBack::find_nearest_left(Ordered& ordered) const {
    const std::size_t count = ordered.entries.size();
    ordered.nearest_left.resize((count + batch_size - 1) / batch_size);
    float left = nothing_seen;
    for (std::size_t i = count; i-- > 0;) {
        left = std::max(left, nearest(ordered.entries[i]));  // what is NaN is seen nowhere
        if (i % batch_size == 0) ordered.nearest_left[i / batch_size] = left;
    }
}

}  // namespace zproof::rasterizer
