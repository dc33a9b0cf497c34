/// Lossless packing of whole buffers, for every file that zproof compresses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace zproof {

/// Makes zlib streams (RFC 1950) by ISA-L's igzip at level 2, which gives files of about the size that zlib's
/// level 1 does. The same bytes give the same stream, on every x86 processor with SSE 4.2.
class Deflater {
  public:
    Deflater();
    ~Deflater();
    Deflater(Deflater&&) noexcept;
    Deflater& operator=(Deflater&&) noexcept;

    std::string deflated(std::string_view bytes);

  private:
    struct Stream;
    std::unique_ptr<Stream> stream_;  ///< its tables take a megabyte: worth keeping between buffers
};

/// One buffer.
std::string deflated(std::string_view bytes);

/// CRC-32 of zlib and PNG (ISO 3309); of two pieces, where that of the first is known.
std::uint32_t crc32_of(std::string_view bytes, std::uint32_t of_before = 0);

/// The bytes that values occupy in memory.
template <class T>
std::string_view bytes_in(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace zproof
