/// Lossless packing of whole buffers, for the planes that report.html embeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zproof {

/// Part of a zlib stream, packed without regard to what stands before it: parts can be made side by side.
struct DeflatedPiece {
    std::string bits;         ///< whole bytes: ends with an empty stored block
    std::uint32_t adler = 1;  ///< Adler-32 of the bytes that it holds
    std::size_t size = 0;     ///< so many bytes
};

/// Makes zlib streams (RFC 1950) by ISA-L's igzip at level 0 with Huffman codes of their own, which gives
/// files of about the size that zlib's level 1 does. The same bytes give the same stream, on every x86
/// processor with SSE 4.2: higher levels do not. At 1 and 2 igzip 2.30 finds other matches in one short text
/// of a thousand, by where in memory its buffer stands; at 3 by the processor's vectors.
class Deflater {
  public:
    Deflater();
    ~Deflater();
    Deflater(Deflater&&) noexcept;
    Deflater& operator=(Deflater&&) noexcept;

    std::string deflated(std::string_view bytes);
    DeflatedPiece piece(std::string_view bytes);

  private:
    struct Stream;
    std::unique_ptr<Stream> stream_;  ///< its tables take 200 KiB: worth keeping between buffers
};

/// The buffer, deflated as a whole.
std::string deflated(std::string_view bytes);

/// The stream that holds what the pieces hold, one after another.
std::string stream_of(std::span<const DeflatedPiece> pieces);

/// One stream of pieces, made on the threads of the surrounding tbb::task_arena; the same for any number of
/// them.
std::string deflated_side_by_side(std::string_view bytes);

/// CRC-32 of zlib (ISO 3309).
std::uint32_t crc32_of(std::string_view bytes);

/// The bytes that values occupy in memory.
template <class T>
std::string_view bytes_in(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace zproof
