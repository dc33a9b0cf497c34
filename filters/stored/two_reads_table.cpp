#include "filters/stored/two_reads_table.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace zproof::texture {

namespace {

constexpr int half_of_cells = TwoReadsTable::cells / 2;

/// Lengths are 16ths of a texel of the finer level.
constexpr int finer_texel = 16, coarser_texel = 32, cell_size = 4;

/// Eighths of a texel to either side of the place.
constexpr int finer_reach = 16, coarser_reach = 4;
constexpr std::size_t finer_places = 2 * finer_reach + 1, coarser_places = 2 * coarser_reach + 1;

/// A bilinear read along one axis: two texels that meet, each with a weight; together they weigh `size`.
struct AxisRead {
    int size;   ///< of a texel
    int first;  ///< where the first one begins
    int second_weight;

    AxisRead(int texel, int place) : size{texel} {
        const int from_centre = place - texel / 2;
        second_weight = (from_centre % texel + texel) % texel;
        first = from_centre - second_weight;
    }
    int first_weight() const { return size - second_weight; }
    int begin(int i) const { return first + i * size; }
    int weight(int i) const { return i == 0 ? first_weight() : second_weight; }
    /// The weights' product with another read's, over the texels' common length.
    int times(const AxisRead& other) const {
        int sum = 0;
        for (int i = 0; i < 2; ++i)
            for (int j = 0; j < 2; ++j)
                sum += weight(i) * other.weight(j) *
                       common(begin(i), begin(i) + size, other.begin(j), other.begin(j) + other.size);
        return sum;
    }
    int times_line(int low, int high) const {
        int sum = 0;
        for (int i = 0; i < 2; ++i) sum += weight(i) * common(begin(i), begin(i) + size, low, high);
        return sum;
    }

  private:
    static int common(int low, int high, int other_low, int other_high) {
        return std::max(0, std::min(high, other_high) - std::max(low, other_low));
    }
};

/// Along one axis, with t the square's line and f, c the densities of the two reads at each place: 2^10 side
/// t f and 2^10 side t c; 2^15 f f, f c and c c.
struct AxisProducts {
    std::array<int, finer_places> line_finer{}, finer_finer{};
    std::array<int, coarser_places> line_coarser{}, coarser_coarser{};
    std::array<std::array<int, coarser_places>, finer_places> finer_coarser{};

    AxisProducts(int side_eighths, int cell) {
        const int centre = cell * cell_size + cell_size / 2, half = side_eighths;
        for (std::size_t i = 0; i < finer_places; ++i) {
            const AxisRead finer{finer_texel, centre + (int(i) - finer_reach) * finer_texel / 8};
            line_finer[i] = 4 * finer.times_line(centre - half, centre + half);
            finer_finer[i] = finer.times(finer) / 2;
            for (std::size_t j = 0; j < coarser_places; ++j) {
                const AxisRead coarser{coarser_texel, centre + (int(j) - coarser_reach) * coarser_texel / 8};
                line_coarser[j] = coarser.times_line(centre - half, centre + half);
                coarser_coarser[j] = coarser.times(coarser) / coarser_texel;
                finer_coarser[i][j] = finer.times(coarser) / 8;
            }
        }
    }
};

/// The squared distance of both reads from the square, but for a constant and in units of 2^-42 side^-2: a
/// parabola over the finer read's share s, in 64ths.
struct Parabola {
    std::int64_t constant, slope, square;  ///< constant - 2 * slope * s + square * s^2, s from 0 to 1

    /// The best share, rounded half up; 64 where all are as good.
    int best() const {
        if (slope >= square) return 64;
        if (slope <= 0) return 0;
        return int((128 * slope + square) / (2 * square));
    }
    std::int64_t at(int share) const { return 4096 * constant + share * (share * square - 128 * slope); }
};

class Search {
  public:
    Search(int side_eighths, const glm::ivec2& cell)
        : across_{side_eighths, cell.x},
          down_{side_eighths, cell.y},
          side_squared_{4 * side_eighths * side_eighths} {}

    TwoReads best() {
        for (std::size_t v = 0; v < finer_places; ++v)
            for (std::size_t u = 0; u < finer_places; ++u)
                for (std::size_t row = 0; row < coarser_places; ++row)
                    for (std::size_t column = 0; column < coarser_places; ++column)
                        try_one(u, v, column, row);
        return best_;
    }

  private:
    void try_one(std::size_t u, std::size_t v, std::size_t column, std::size_t row) {
        const std::int64_t line_finer = std::int64_t{across_.line_finer[u]} * down_.line_finer[v],
                           line_coarser =
                               std::int64_t{across_.line_coarser[column]} * down_.line_coarser[row],
                           finer_finer = std::int64_t{across_.finer_finer[u]} * down_.finer_finer[v],
                           finer_coarser =
                               std::int64_t{across_.finer_coarser[u][column]} * down_.finer_coarser[v][row],
                           coarser_coarser =
                               std::int64_t{across_.coarser_coarser[column]} * down_.coarser_coarser[row];
        const Parabola error{
            .constant = side_squared_ * coarser_coarser - 2048 * line_coarser,
            .slope = 1024 * (line_finer - line_coarser) - side_squared_ * (finer_coarser - coarser_coarser),
            .square = side_squared_ * (finer_finer - 2 * finer_coarser + coarser_coarser)};
        const int share = error.best();
        const std::int64_t now = error.at(share);
        if (now >= least_) return;
        least_ = now;
        best_ = {.finer = {int(u) - finer_reach, int(v) - finer_reach},
                 .coarser = {int(column) - coarser_reach, int(row) - coarser_reach},
                 .share = share};
    }

    AxisProducts across_, down_;
    std::int64_t side_squared_;  ///< 256ths of a texel
    std::int64_t least_ = std::numeric_limits<std::int64_t>::max();
    TwoReads best_;
};

}  // namespace

TwoReadsTable::TwoReadsTable() {
    for (int side = least_side; side <= most_side; ++side)
        for (int row = 0; row < half_of_cells; ++row)
            for (int column = 0; column < half_of_cells; ++column)
                entries_.push_back(Search{side, {column, row}}.best());
}

TwoReads TwoReadsTable::at(int side, const glm::ivec2& cell) const {
    const glm::ivec2 mirrored = glm::min(cell, cells - 1 - cell);
    TwoReads reads = entries_[std::size_t(((side - least_side) * half_of_cells + mirrored.y) * half_of_cells +
                                          mirrored.x)];
    for (int axis = 0; axis < 2; ++axis)
        if (cell[axis] != mirrored[axis])
            reads.finer[axis] = -reads.finer[axis], reads.coarser[axis] = -reads.coarser[axis];
    return reads;
}

}  // namespace zproof::texture
