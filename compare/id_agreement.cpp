#include "compare/id_agreement.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <stdexcept>

namespace zproof {

namespace {

using Frames = std::span<const Frame* const>;
using Rows = tbb::blocked_range<int>;

IdAgreement none_of(std::size_t frames) {
    return {.same = {frames, std::vector<std::uint64_t>(frames)}, .unanimous = 0};
}

IdAgreement sum_of(IdAgreement a, const IdAgreement& b) {
    for (std::size_t i = 0; i < a.same.size(); ++i)
        std::ranges::transform(a.same[i], b.same[i], a.same[i].begin(), std::plus{});
    a.unanimous += b.unanimous;
    return a;
}

std::uint32_t same_in_row(std::span<const PrimitiveId> a, std::span<const PrimitiveId> b) {
    std::uint32_t count = 0;
    for (std::size_t x = 0; x < a.size(); ++x) count += a[x] == b[x];
    return count;
}

std::uint64_t unanimous_in_row(Frames frames, int y) {
    const std::span first = frames.front()->primitive.row(y);
    std::vector<std::uint8_t> all(first.size(), 1);
    for (const Frame* frame : frames.subspan(1))
        for (std::size_t x = 0; x < first.size(); ++x) all[x] &= frame->primitive.row(y)[x] == first[x];
    return std::uint64_t(std::ranges::count(all, 1));
}

/// Counts each pair in one order only. Whether all agree is counted for more than two frames.
IdAgreement with_row(IdAgreement sum, Frames frames, int y) {
    for (std::size_t i = 0; i < frames.size(); ++i)
        for (std::size_t j = i + 1; j < frames.size(); ++j)
            sum.same[i][j] += same_in_row(frames[i]->primitive.row(y), frames[j]->primitive.row(y));
    if (frames.size() > 2) sum.unanimous += unanimous_in_row(frames, y);
    return sum;
}

/// Each frame agrees with itself at every pixel, and of two or fewer all agree where the outer ones do.
IdAgreement completed(IdAgreement sum, std::uint64_t pixels) {
    for (std::size_t i = 0; i < sum.same.size(); ++i) {
        sum.same[i][i] = pixels;
        for (std::size_t j = 0; j < i; ++j) sum.same[i][j] = sum.same[j][i];
    }
    if (sum.same.size() <= 2) sum.unanimous = sum.same.front().back();
    return sum;
}

}  // namespace

IdAgreement count_id_agreement(Frames frames) {
    const Resolution size = frames.front()->size();
    for (const Frame* frame : frames)
        if (frame->size() != size)
            throw std::invalid_argument{"count_id_agreement: frames of different sizes"};
    IdAgreement counted = tbb::parallel_reduce(
        Rows{0, size.height}, none_of(frames.size()),
        [&](const Rows& rows, IdAgreement sum) {
            for (int y = rows.begin(); y != rows.end(); ++y) sum = with_row(std::move(sum), frames, y);
            return sum;
        },
        sum_of);
    return completed(std::move(counted), size.pixel_count());
}

}  // namespace zproof
