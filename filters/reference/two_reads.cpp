#include "filters/reference/two_reads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace zproof::oracle::filter_reference {

namespace {

/// A line of 16ths of the finer level's texel, about the coarser texel that holds the place.
constexpr int line_first = -64, line_length = 160;
using Line = std::array<std::int64_t, line_length>;

std::int64_t product(const Line& a, const Line& b) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// A line of 16ths: 1 where the square is.
Line square_at(int centre, int half) {
    Line line{};
    for (int i = 0; i < line_length; ++i)
        if (const int at = line_first + i; at >= centre - half && at < centre + half)
            line[std::size_t(i)] = 1;
    return line;
}

/// 2^10 times the density of a bilinear read: a texel weighs 1 where the place is its centre, and nothing a
/// texel beside that.
Line read_at(int place, int texel) {
    Line line{};
    for (int i = 0; i < line_length; ++i) {
        const int at = line_first + i, texel_begin = int(std::floor(double(at) / texel)) * texel,
                  from_centre = std::abs(2 * texel_begin + texel - 2 * place);
        line[std::size_t(i)] = std::max(0, 2 * texel - from_centre) * 512 / (texel * texel);
    }
    return line;
}

constexpr int finer_most = 16, coarser_most = 4;

/// Along one axis of an entry. In the further half of the coarser texel displacements count from the positive
/// end: it is the nearer half's mirror image.
class Axis {
  public:
    Axis(int side, int cell) : sign_{cell < TwoReadsSearch::cells / 2 ? 1 : -1} {
        const int centre = 4 * cell + 2;
        const Line square = square_at(centre, side);
        for (int i = -finer_most; i <= finer_most; ++i) finer_.push_back(read_at(centre + 2 * sign_ * i, 16));
        for (int i = -coarser_most; i <= coarser_most; ++i)
            coarser_.push_back(read_at(centre + 4 * sign_ * i, 32));
        for (const Line& f : finer_) {
            square_finer.push_back(product(square, f)), finer_finer.push_back(product(f, f));
            finer_coarser.emplace_back();
            for (const Line& c : coarser_) finer_coarser.back().push_back(product(f, c));
        }
        for (const Line& c : coarser_)
            square_coarser.push_back(product(square, c)), coarser_coarser.push_back(product(c, c));
    }
    std::size_t finer_count() const { return finer_.size(); }
    std::size_t coarser_count() const { return coarser_.size(); }
    int finer_displacement(std::size_t i) const { return sign_ * (int(i) - finer_most); }
    int coarser_displacement(std::size_t i) const { return sign_ * (int(i) - coarser_most); }

    std::vector<std::int64_t> square_finer, square_coarser, finer_finer, coarser_coarser;
    std::vector<std::vector<std::int64_t>> finer_coarser;

  private:
    int sign_;
    std::vector<Line> finer_, coarser_;
};

struct Weighed {
    int share;
    std::int64_t error;
};

/// |square - s finer - (1 - s) coarser|^2, less the square's own, times 2^52 side^2 of 16ths; s in 64ths.
struct Distance {
    std::int64_t side_squared, square_finer, square_coarser, finer_finer, finer_coarser, coarser_coarser;

    std::int64_t of(std::int64_t s) const {
        const std::int64_t rest = 64 - s, cross = (std::int64_t{1} << 21) * 64;
        return side_squared *
                   (s * s * finer_finer + 2 * s * rest * finer_coarser + rest * rest * coarser_coarser) -
               cross * (s * square_finer + rest * square_coarser);
    }
    /// The first share from 64 down that is best. The distance is a parabola: it is next to the vertex.
    Weighed best() const {
        const double slope = double(of(64) - of(0)), bend = double(of(64) - 2 * of(32) + of(0)),
                     vertex = bend > 0 ? 32 - 16 * slope / bend : 64;
        const int near = int(std::clamp(std::floor(vertex), 0.0, 64.0));
        Weighed best{0, std::numeric_limits<std::int64_t>::max()};
        for (int share = std::min(near + 2, 64); share >= std::max(near - 1, 0); --share)
            if (const std::int64_t error = of(share); error < best.error) best = {share, error};
        return best;
    }
};

TwoReadsFound search(int side, int column_cell, int row_cell) {
    const Axis u{side, column_cell}, v{side, row_cell};
    TwoReadsFound found{};
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (std::size_t fv = 0; fv < v.finer_count(); ++fv)
        for (std::size_t fu = 0; fu < u.finer_count(); ++fu)
            for (std::size_t cv = 0; cv < v.coarser_count(); ++cv)
                for (std::size_t cu = 0; cu < u.coarser_count(); ++cu) {
                    const Weighed now = Distance{4 * side * side,
                                                 u.square_finer[fu] * v.square_finer[fv],
                                                 u.square_coarser[cu] * v.square_coarser[cv],
                                                 u.finer_finer[fu] * v.finer_finer[fv],
                                                 u.finer_coarser[fu][cu] * v.finer_coarser[fv][cv],
                                                 u.coarser_coarser[cu] * v.coarser_coarser[cv]}
                                            .best();
                    if (now.error >= least) continue;
                    least = now.error;
                    found = {{u.finer_displacement(fu), v.finer_displacement(fv)},
                             {u.coarser_displacement(cu), v.coarser_displacement(cv)},
                             now.share};
                }
    return found;
}

}  // namespace

const TwoReadsFound& TwoReadsSearch::at(int side, int column, int row) {
    const std::size_t entry = (std::size_t(side) * cells + std::size_t(row)) * cells + std::size_t(column);
    std::call_once(once_[entry], [&] { found_[entry] = search(side, column, row); });
    return found_[entry];
}

TwoReadsSearch& two_reads_search() {
    static TwoReadsSearch search;
    return search;
}

}  // namespace zproof::oracle::filter_reference
