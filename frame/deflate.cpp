#include "frame/deflate.h"

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace zproof {
namespace {

/// igzip's lengths are 32-bit; inputs beyond this are handed over piece by piece.
constexpr std::size_t largest_piece = std::size_t{1} << 30;

/// igzip declares what it only reads as writable.
std::uint8_t* readable(std::string_view bytes) {
    return reinterpret_cast<std::uint8_t*>(const_cast<char*>(bytes.data()));
}

}  // namespace

struct Deflater::Stream {
    isal_zstream state;
    std::unique_ptr<std::uint8_t[]> tables =
        std::make_unique_for_overwrite<std::uint8_t[]>(ISAL_DEF_LVL2_LARGE);

    void begin() {
        isal_deflate_init(&state);
        state.level = 2;
        state.level_buf = tables.get();
        state.level_buf_size = ISAL_DEF_LVL2_LARGE;
        state.gzip_flag = IGZIP_ZLIB;
    }

    /// The last piece ends the stream.
    void take(std::string_view piece, std::string_view rest) {
        state.next_in = readable(piece);
        state.avail_in = static_cast<std::uint32_t>(piece.size());
        state.end_of_stream = rest.empty();
    }

    /// Fills `room` as far as there is something to write. How much that was: less than all where the piece
    /// is used up.
    std::size_t write(std::span<char> room) {
        state.next_out = reinterpret_cast<std::uint8_t*>(room.data());
        state.avail_out = static_cast<std::uint32_t>(room.size());
        if (isal_deflate(&state) != COMP_OK) throw std::logic_error{"igzip refused what it should pack"};
        return room.size() - state.avail_out;
    }
};

Deflater::Deflater() : stream_(std::make_unique<Stream>()) {}
Deflater::~Deflater() = default;
Deflater::Deflater(Deflater&&) noexcept = default;
Deflater& Deflater::operator=(Deflater&&) noexcept = default;

std::string Deflater::deflated(std::string_view bytes) {
    const std::size_t room = std::min(bytes.size() / 4 + 1024, largest_piece);
    const auto out = std::make_unique_for_overwrite<char[]>(room);
    std::string packed;
    stream_->begin();
    do {
        const std::string_view piece = bytes.substr(0, largest_piece);
        bytes.remove_prefix(piece.size());
        stream_->take(piece, bytes);
        for (std::size_t written = room; written == room;) {
            written = stream_->write({out.get(), room});
            packed.append(out.get(), written);
        }
    } while (!bytes.empty());
    return packed;
}

std::string deflated(std::string_view bytes) { return Deflater{}.deflated(bytes); }

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t of_before) {
    return crc32_gzip_refl(of_before, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace zproof
