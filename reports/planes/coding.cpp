#include "reports/planes/coding.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <functional>
#include <utility>

#include "reports/planes/deflate.h"

namespace zproof::planes {

static_assert(std::endian::native == std::endian::little, "planes are stored as they lie in memory");

namespace {

std::uint32_t folded(std::uint32_t difference) { return (difference << 1) ^ (0u - (difference >> 31)); }

/// The lowest byte of every number once it is shifted.
void take_bytes(const std::uint32_t* values, std::size_t count, int shift, char* to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = char(values[i] >> shift);
}
void take_bytes(const std::uint64_t* values, std::size_t count, int shift, char* to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = char(values[i] >> shift);
}

/// The number of bytes of such a number that are not zero.
template <class T>
std::size_t bytes_of(T any) {
    return (std::size_t(std::bit_width(any)) + 7) / 8;
}

/// Byte k of every number, for k = 0, 1, ... until the rest is zero.
std::string deflated_byte_planes(std::span<const std::uint64_t> values) {
    std::uint64_t any = 0;
    for (const std::uint64_t value : values) any |= value;
    std::string bytes(bytes_of(any) * values.size(), '\0');
    for (std::size_t k = 0; k < bytes_of(any); ++k)
        take_bytes(values.data(), values.size(), int(8 * k), bytes.data() + k * values.size());
    return deflated_side_by_side(bytes);
}

/// Numbers one after another, in rows of which the last may be shorter.
struct Rows {
    std::size_t size, width;

    std::size_t in_piece() const { return std::max<std::size_t>(1, (std::size_t{1} << 17) / width); }
    std::size_t piece_size() const { return in_piece() * width; }
    std::size_t pieces() const { return (size + piece_size() - 1) / piece_size(); }
    std::size_t size_of_piece(std::size_t i) const { return std::min(piece_size(), size - i * piece_size()); }
};

/// Writes what the prediction misses of the numbers from `first` on: of one row, or part of one.
using MissRow = std::function<void(std::size_t first, std::span<std::uint32_t> missed)>;

/// The byte planes of some rows, packed, but for those in which all is zero.
struct RowsPiece {
    std::array<DeflatedPiece, 4> byte;
    std::uint32_t any = 0;  ///< the bits that some number has
};

/// Makes pieces, one after another, in memory of its own.
class PieceMaker {
  public:
    RowsPiece piece(const Rows& rows, const MissRow& miss, std::size_t i) {
        const std::size_t size = rows.size_of_piece(i);
        for (std::string& bytes : bytes_) bytes.resize(size);
        missed_.resize(rows.width);
        RowsPiece made;
        for (std::size_t at = 0; at < size; at += rows.width) {
            const std::span<std::uint32_t> row = std::span(missed_).first(std::min(rows.width, size - at));
            miss(i * rows.piece_size() + at, row);
            made.any |= any_of(row);
            for (std::size_t k = 0; k < bytes_.size(); ++k)
                take_bytes(row.data(), row.size(), int(8 * k), bytes_[k].data() + at);
        }
        for (std::size_t k = 0; k < bytes_of(made.any); ++k) made.byte[k] = deflater_.piece(bytes_[k]);
        return made;
    }

  private:
    static std::uint32_t any_of(std::span<const std::uint32_t> values) {
        std::uint32_t any = 0;
        for (const std::uint32_t value : values) any |= value;
        return any;
    }

    Deflater deflater_;
    std::vector<std::uint32_t> missed_;
    std::array<std::string, 4> bytes_;
};

/// Byte k of every missed number, for k = 0, 1, ... until the rest is zero; pieces are made side by side.
std::string deflated_byte_planes(const Rows& rows, const MissRow& miss) {
    std::vector<RowsPiece> pieces(rows.pieces());
    tbb::enumerable_thread_specific<PieceMaker> makers;
    tbb::parallel_for(std::size_t(0), pieces.size(),
                      [&](std::size_t i) { pieces[i] = makers.local().piece(rows, miss, i); });
    std::uint32_t any = 0;
    for (const RowsPiece& piece : pieces) any |= piece.any;
    std::vector<DeflatedPiece> stream;
    Deflater deflater;
    for (std::size_t k = 0; k < bytes_of(any); ++k)
        for (std::size_t i = 0; i < pieces.size(); ++i)
            stream.push_back(k < bytes_of(pieces[i].any)
                                 ? std::move(pieces[i].byte[k])
                                 : deflater.piece(std::string(rows.size_of_piece(i), '\0')));
    return stream_of(stream);
}

/// What left prediction misses of a row.
void miss_left(Words row, std::span<std::uint32_t> missed) {
    missed[0] = folded(row[0]);
    for (std::size_t i = 1; i < missed.size(); ++i) missed[i] = folded(row[i] - row[i - 1]);
}

void miss_planar(Words upper, Words row, std::span<std::uint32_t> missed) {
    missed[0] = folded(row[0] - upper[0]);
    for (std::size_t i = 1; i < missed.size(); ++i)
        missed[i] = folded(row[i] - row[i - 1] - (upper[i] - upper[i - 1]));
}

void miss_beside(Words values, Words guess, std::span<std::uint32_t> missed) {
    for (std::size_t i = 0; i < missed.size(); ++i) missed[i] = folded(values[i] - guess[i]);
}

std::uint32_t count_unlike(Words a, Words b) {
    std::uint32_t unlike = 0;
    for (std::size_t i = 0; i < a.size(); ++i) unlike += a[i] != b[i];
    return unlike;
}

/// Runs of numbers that are searched for what differs only where something does.
constexpr std::size_t run_size = 1024;

}  // namespace

std::string encode(Words values, std::size_t width, Prediction prediction) {
    assert(width > 0 && values.size() % width == 0);
    return deflated_byte_planes({values.size(), width}, [&](std::size_t at, std::span<std::uint32_t> missed) {
        const Words row = values.part(at, width);
        if (prediction == Prediction::left || at == 0)
            miss_left(row, missed);
        else
            miss_planar(values.part(at - width, width), row, missed);
    });
}

std::string encode(Words values, Words guess) {
    assert(values.size() == guess.size());
    return deflated_byte_planes(
        {values.size(), run_size}, [&](std::size_t at, std::span<std::uint32_t> missed) {
            miss_beside(values.part(at, missed.size()), guess.part(at, missed.size()), missed);
        });
}

std::string encode_sparse(Words values, Words guess) {
    assert(values.size() == guess.size());
    std::vector<std::uint32_t> places, kept;
    for (std::size_t first = 0; first < values.size(); first += run_size) {
        const std::size_t count = std::min(run_size, values.size() - first);
        if (count_unlike(values.part(first, count), guess.part(first, count)) == 0) continue;
        for (std::size_t i = first; i < first + count; ++i) {
            if (values[i] == guess[i]) continue;
            places.push_back(std::uint32_t(i));
            kept.push_back(values[i]);
        }
    }
    const std::size_t width = std::max<std::size_t>(places.size(), 1);
    places.insert(places.end(), kept.begin(), kept.end());
    return encode(places, width, Prediction::left);
}

std::size_t missed_by(Words values, Words guess) {
    std::size_t missed = 0;
    for (std::size_t first = 0; first < values.size(); first += run_size) {
        const std::size_t count = std::min(run_size, values.size() - first);
        missed += count_unlike(values.part(first, count), guess.part(first, count));
    }
    return missed;
}

std::string encode_runs(std::string_view values) {
    std::string runs;
    for (std::size_t first = 0, end = 0; first < values.size(); first = end) {
        end = std::min(values.find_first_not_of(values[first], first), values.size());
        std::size_t length = end - first;
        for (; length > 127; length >>= 7) runs += char(128 | (length & 127));
        runs += char(length);
        runs += values[first];
    }
    return deflated(runs);
}

std::string encode(std::span<const double> values) {
    std::vector<std::uint64_t> bits;
    for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
    return deflated_byte_planes(bits);
}

}  // namespace zproof::planes
