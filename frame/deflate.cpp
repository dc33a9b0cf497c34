#include "frame/deflate.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace zproof {
namespace {

/// igzip's lengths are 32-bit; inputs beyond this are handed over piece by piece.
constexpr std::size_t largest_piece = std::size_t{1} << 30;

/// What is written at once.
constexpr std::size_t room_bytes = std::size_t{1} << 16;

/// A piece of a long text: its first repetitions, which may not look back to what stands before, weigh
/// little.
constexpr std::size_t piece_bytes = std::size_t{1} << 17;

/// igzip declares what it only reads as writable.
std::uint8_t* readable(std::string_view bytes) {
    return reinterpret_cast<std::uint8_t*>(const_cast<char*>(bytes.data()));
}

/// Adler-32 of what has the sum `before` and the piece after it. The low half is 1 plus the sum of all bytes,
/// the high one the sum of the low halves after every byte, modulo 65521 (RFC 1950, 8.2): each of the piece's
/// lacks `before`'s bytes.
std::uint32_t adler_of_both(std::uint32_t before, const DeflatedPiece& piece) {
    constexpr std::uint64_t modulus = 65521;
    const std::uint64_t bytes_before = (before & 0xFFFF) + modulus - 1;
    const std::uint64_t low = (piece.adler & 0xFFFF) + bytes_before;
    const std::uint64_t high = (before >> 16) + (piece.adler >> 16) + piece.size % modulus * bytes_before;
    return static_cast<std::uint32_t>(high % modulus << 16 | low % modulus);
}

}  // namespace

struct Deflater::Stream {
    isal_zstream state;
    std::unique_ptr<std::uint8_t[]> tables =
        std::make_unique_for_overwrite<std::uint8_t[]>(ISAL_DEF_LVL2_LARGE);
    std::unique_ptr<char[]> room = std::make_unique_for_overwrite<char[]>(room_bytes);

    /// `wrapping`: IGZIP_ZLIB, or IGZIP_DEFLATE for bare blocks.
    void begin(std::uint16_t wrapping, std::uint16_t flush) {
        isal_deflate_init(&state);
        state.level = 2;
        state.level_buf = tables.get();
        state.level_buf_size = ISAL_DEF_LVL2_LARGE;
        state.gzip_flag = wrapping;
        state.flush = flush;
    }

    /// Appends all that becomes of the bytes; `is_last`: nothing follows.
    void pack(std::string_view bytes, std::uint16_t is_last, std::string& packed) {
        state.next_in = readable(bytes);
        state.avail_in = static_cast<std::uint32_t>(bytes.size());
        state.end_of_stream = is_last;
        for (std::size_t written = room_bytes; written == room_bytes;) {
            written = write();
            packed.append(room.get(), written);
        }
    }

    /// Fills the room as far as there is something to write. How much that was: less than all where the bytes
    /// are used up.
    std::size_t write() {
        state.next_out = reinterpret_cast<std::uint8_t*>(room.get());
        state.avail_out = static_cast<std::uint32_t>(room_bytes);
        if (isal_deflate(&state) != COMP_OK) throw std::logic_error{"igzip refused what it should pack"};
        return room_bytes - state.avail_out;
    }
};

Deflater::Deflater() : stream_(std::make_unique<Stream>()) {}
Deflater::~Deflater() = default;
Deflater::Deflater(Deflater&&) noexcept = default;
Deflater& Deflater::operator=(Deflater&&) noexcept = default;

std::string Deflater::deflated(std::string_view bytes) {
    std::string packed;
    stream_->begin(IGZIP_ZLIB, NO_FLUSH);
    do {
        const std::string_view part = bytes.substr(0, largest_piece);
        bytes.remove_prefix(part.size());
        stream_->pack(part, bytes.empty(), packed);
    } while (!bytes.empty());
    return packed;
}

DeflatedPiece Deflater::piece(std::string_view bytes) {
    if (bytes.size() > largest_piece) throw std::logic_error{"a piece of a stream is too large"};
    DeflatedPiece made{
        .bits = "", .adler = isal_adler32(1, readable(bytes), bytes.size()), .size = bytes.size()};
    if (bytes.empty()) return made;
    stream_->begin(IGZIP_DEFLATE, FULL_FLUSH);
    stream_->pack(bytes, 0, made.bits);
    return made;
}

std::string deflated(std::string_view bytes) { return Deflater{}.deflated(bytes); }

std::string joined(std::span<const DeflatedPiece> pieces) {
    std::size_t size = 8;
    for (const DeflatedPiece& piece : pieces) size += piece.bits.size();
    std::string stream;
    stream.reserve(size);
    stream = "\x78\x01";  // RFC 1950: deflate, a window of 32 KiB
    std::uint32_t adler = 1;
    for (const DeflatedPiece& piece : pieces) {
        stream += piece.bits;
        adler = adler_of_both(adler, piece);
    }
    stream.append("\x03\x00", 2);  // RFC 1951: a last block, of fixed codes, that ends at once
    for (const int shift : {24, 16, 8, 0}) stream += static_cast<char>(adler >> shift & 0xFF);
    return stream;
}

std::string deflated_side_by_side(std::size_t count, const FillPiece& fill) {
    struct Desk {
        Deflater deflater;
        std::string room;
    };
    tbb::enumerable_thread_specific<Desk> desks;
    std::vector<DeflatedPiece> pieces(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        Desk& desk = desks.local();
        pieces[i] = desk.deflater.piece(fill(i, desk.room));
    });
    return joined(pieces);
}

std::string deflated_side_by_side(std::string_view bytes) {
    return deflated_side_by_side(
        (bytes.size() + piece_bytes - 1) / piece_bytes,
        [&](std::size_t i, std::string&) { return bytes.substr(i * piece_bytes, piece_bytes); });
}

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t of_before) {
    return crc32_gzip_refl(of_before, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace zproof
