/// The ids that Cryptomatte gives to names (Friedman and Jones, "Fully automatic ID mattes with support for
/// motion blur and transparency", 2015; specification 1.2.0).
#pragma once

#include <cstdint>
#include <string_view>

namespace zproof {

/// MurmurHash3_x86_32 of the bytes, with seed 0 (Austin Appleby's public domain code).
std::uint32_t murmur_hash3(std::string_view bytes);

/// The hash with bit 23 turned where it would be no finite, normal float32. It is never 0 or 0xFFFFFFFF.
std::uint32_t cryptomatte_id(std::string_view name);

}  // namespace zproof
