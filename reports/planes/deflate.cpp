#include "reports/planes/deflate.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

namespace zproof {
namespace {

/// igzip's lengths are 32-bit; inputs beyond this are handed over piece by piece.
constexpr std::size_t largest_piece = std::size_t{1} << 30;

/// What is written at once.
constexpr std::size_t room_bytes = std::size_t{1} << 16;

/// igzip packs nothing before it has more than that, or is told to end.
constexpr std::size_t buffered_bytes = IGZIP_HIST_SIZE;

/// A table of codes takes some hundred bytes. To count symbols in all of them takes a third of the time to
/// pack them, and saves 2 % of the files.
constexpr std::size_t own_codes_from = 4096, sample_bytes = 16384;

enum class BlockEnding { none, piece, stream };

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
    isal_huff_histogram histogram;
    isal_hufftables codes;
    std::unique_ptr<char[]> room = std::make_unique_for_overwrite<char[]>(room_bytes);

    /// `wrapping`: IGZIP_ZLIB, or IGZIP_DEFLATE for bare blocks. Nothing in igzip's buffer is left of what
    /// was packed before: it looks a few bytes further than there are.
    void begin(std::uint16_t wrapping) {
        std::memset(&state, 0, sizeof state);
        isal_deflate_init(&state);
        state.gzip_flag = wrapping;
    }

    /// Appends what becomes of all bytes. What igzip sees behind the last ones has to be its own buffer's,
    /// not what follows them in the caller's memory: it takes all into that buffer where they are few, and
    /// keeps the last of many there until it is told to end.
    void pack(std::string_view bytes, BlockEnding ending, std::string& packed) {
        choose_codes(bytes);
        if (bytes.size() > buffered_bytes) {
            for (std::size_t at = 0; at < bytes.size(); at += largest_piece)
                write_all(bytes.substr(at, largest_piece), BlockEnding::none, packed);
            bytes = {};
        }
        write_all(bytes, ending, packed);
    }

    /// Chooses codes by how often each symbol will be written in the first bytes; few bytes get RFC 1951's
    /// fixed codes.
    void choose_codes(std::string_view bytes) {
        const bool are_own = bytes.size() >= own_codes_from;
        if (are_own) {
            const std::string_view sample = bytes.substr(0, sample_bytes);
            std::memset(&histogram, 0, sizeof histogram);
            isal_update_histogram(readable(sample), static_cast<int>(sample.size()), &histogram);
            if (isal_create_hufftables(&codes, &histogram) != COMP_OK)
                throw std::logic_error{"igzip makes no codes of what it counted"};
        }
        const int kind = are_own ? IGZIP_HUFFTABLE_CUSTOM : IGZIP_HUFFTABLE_STATIC;
        if (isal_deflate_set_hufftables(&state, are_own ? &codes : nullptr, kind) != COMP_OK)
            throw std::logic_error{"igzip refused codes of its own"};
    }

    void write_all(std::string_view bytes, BlockEnding ending, std::string& packed) {
        state.next_in = readable(bytes);
        state.avail_in = static_cast<std::uint32_t>(bytes.size());
        state.flush = ending == BlockEnding::piece ? FULL_FLUSH : NO_FLUSH;
        state.end_of_stream = ending == BlockEnding::stream ? 1 : 0;
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
    stream_->begin(IGZIP_ZLIB);
    stream_->pack(bytes, BlockEnding::stream, packed);
    return packed;
}

DeflatedPiece Deflater::piece(std::string_view bytes) {
    if (bytes.size() > largest_piece) throw std::logic_error{"a piece of a stream is too large"};
    DeflatedPiece made{
        .bits = "", .adler = isal_adler32(1, readable(bytes), bytes.size()), .size = bytes.size()};
    if (bytes.empty()) return made;
    stream_->begin(IGZIP_DEFLATE);
    stream_->pack(bytes, BlockEnding::piece, made.bits);
    return made;
}

std::string deflated(std::string_view bytes) { return Deflater{}.deflated(bytes); }

std::string stream_of(std::span<const DeflatedPiece> pieces) {
    std::string stream("\x78\x01");  // RFC 1950: deflate, a window of 32 KiB
    std::uint32_t adler = 1;
    for (const DeflatedPiece& piece : pieces) {
        stream += piece.bits;
        adler = adler_of_both(adler, piece);
    }
    stream.append("\x03\x00", 2);  // RFC 1951: a last block that ends at once
    for (const int shift : {24, 16, 8, 0}) stream += static_cast<char>(adler >> shift & 0xFF);
    return stream;
}

std::string deflated_side_by_side(std::string_view bytes) {
    tbb::enumerable_thread_specific<Deflater> deflaters;
    std::vector<DeflatedPiece> pieces((bytes.size() + piece_bytes - 1) / piece_bytes);
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        pieces[i] = deflaters.local().piece(bytes.substr(i * piece_bytes, piece_bytes));
    });
    return stream_of(pieces);
}

std::uint32_t crc32_of(std::string_view bytes) {
    return crc32_gzip_refl(0, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace zproof
