/// Buffer views that meshoptimizer compressed (EXT_meshopt_compression).
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace zproof {

/// What the extension says of one buffer view; the numbers are checked integers below 2^31.
struct MeshoptView {
    std::size_t buffer = 0, offset = 0, bytes = 0;  ///< where the stream lies
    std::size_t stride = 0, count = 0;
    std::string mode, filter;  ///< "ATTRIBUTES", "TRIANGLES", "INDICES"; "NONE", "OCTAHEDRAL", ...
};

/// Whether this build has the decoder.
bool has_meshopt();

/// Why the extension forbids the combination, or nothing.
std::string fault_of(const MeshoptView& view);

/// Decodes a stream into stride x count bytes. The view is without fault. False where the stream is broken.
bool decode_meshopt(const MeshoptView& view, std::span<const unsigned char> stream,
                    std::span<unsigned char> to);

}  // namespace zproof
