#include "reports/id_colours.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "math/widest.h"
#include "reports/rgb_words.h"

namespace zproof {

namespace {

constexpr std::size_t together = 256;
using Block = std::array<std::uint32_t, together>;

/// Bijective, so different ids stay different: the finalizer of MurmurHash3.
inline std::uint32_t scrambled(std::uint32_t h) {
    h = (h ^ (h >> 16)) * 0x85EB'CA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2'AE35u;
    return h ^ (h >> 16);
}

inline double within_0_and_1(double value) {
    const double raised = value < 0 ? 0 : value;
    return raised > 1 ? 1 : raised;
}

/// One of the channels, which differ in their shift: hue in turns, [0, 1); saturation and value in [0, 1]
/// (Smith 1978).
struct Hsv {
    double hue, saturation, value;

    inline std::uint32_t channel(double shift) const {
        const double turned = shift + 6 * hue, k = turned - (turned < 6 ? 0.0 : 6.0);
        const double fall = 4 - k, least = fall < k ? fall : k;
        const double light = value * (1 - saturation * within_0_and_1(least));
        // NOLINTNEXTLINE(bugprone-incorrect-roundings): never negative
        return std::uint32_t(std::int32_t(255 * within_0_and_1(light) + 0.5));
    }
};

/// No branches, so that neighbours are done side by side.
void colour_block(const Block& ids, std::size_t count, Block& colours) {
    constexpr std::uint32_t background = word_of(background_colour);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t h = scrambled(ids[i] + 1);
        const Hsv colour{std::int32_t(h & 0xFFFF) / 65536.0,
                         0.35 + 0.3 * double(std::int32_t(h >> 16 & 0xFF)) / 255,
                         0.6 + 0.38 * double(std::int32_t(h >> 24)) / 255};
        const std::uint32_t mixed = colour.channel(5) | colour.channel(3) << 8 | colour.channel(1) << 16;
        colours[i] = ids[i] == std::uint32_t(PrimitiveId::none) ? background : mixed;
    }
}

/// Neighbours of one id are a run, whose colour is made once.
struct Runs {
    Block ids;                                ///< one of each
    std::array<std::uint16_t, together> run;  ///< that a pixel is in
    std::size_t count = 0;

    void find(std::span<const PrimitiveId> pixels) {
        std::size_t last = 0;
        for (std::size_t x = 0; x < pixels.size(); ++x) {
            last += x > 0 && pixels[x] != pixels[x - 1];
            ids[last] = std::uint32_t(pixels[x]);
            run[x] = std::uint16_t(last);
        }
        count = last + 1;
    }
};

}  // namespace

void colour_ids(std::span<const PrimitiveId> ids, std::span<Rgb8> pixels) {
    assert(ids.size() == pixels.size());
    Runs runs;
    Block colours, words;
    for (std::size_t first = 0; first < ids.size(); first += together) {
        const std::size_t count = std::min(together, ids.size() - first);
        runs.find(ids.subspan(first, count));
        widest<colour_block>(runs.ids, runs.count, colours);
        for (std::size_t i = 0; i < count; ++i) words[i] = colours[runs.run[i]];
        store(std::span(words).first(count), pixels.subspan(first, count));
    }
}

}  // namespace zproof
