#include "frame/id_agreement.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace zproof {

IdAgreement count_id_agreement(std::span<const Frame* const> frames) {
    for (const Frame* frame : frames)
        if (frame->size() != frames.front()->size())
            throw std::invalid_argument{"count_id_agreement: frames of different sizes"};
    IdAgreement counted{.same = {frames.size(), std::vector<std::uint64_t>(frames.size())}};
    for (std::size_t i = 0; i < frames.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const auto a = frames[i]->primitive.pixels(), b = frames[j]->primitive.pixels();
            counted.same[i][j] = counted.same[j][i] = std::transform_reduce(
                a.begin(), a.end(), b.begin(), std::uint64_t{0}, std::plus{}, std::equal_to{});
        }
    counted.unanimous = counted.same.front().back();
    if (frames.size() <= 2) return counted;
    counted.unanimous = 0;
    const auto first = frames.front()->primitive.pixels();
    for (std::size_t pixel = 0; pixel < first.size(); ++pixel)
        counted.unanimous += std::ranges::all_of(
            frames, [&](const Frame* f) { return f->primitive.pixels()[pixel] == first[pixel]; });
    return counted;
}

}  // namespace zproof
