/// Meshes that Draco compressed (KHR_draco_mesh_compression).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zproof {

/// An attribute of the stream, and what the glTF file says of it.
struct DracoAttribute {
    std::uint32_t id = 0;    ///< in the stream
    int component_type = 0;  ///< glTF's number
    int components = 0;
};

/// What a glTF file says of one stream.
struct DracoMesh {
    std::uint64_t vertices = 0;
    std::optional<std::uint64_t> corners;  ///< none where the file has no accessor for the indices
    std::vector<DracoAttribute> attributes;
};

struct DecodedDraco {
    std::vector<std::uint32_t> indices;                  ///< in the decoder's order
    std::vector<std::vector<unsigned char>> attributes;  ///< tightly packed, as DracoMesh lists them
    std::string fault;                                   ///< why there is nothing else; empty: all is there
};

/// Whether this build has the decoder.
bool has_draco();

/// The number of triangles that the stream's header states; none where it has no such header.
std::optional<std::uint64_t> draco_triangles(std::span<const unsigned char> stream);

/// Decodes a stream. Counts are compared with what the file says before the decoder allocates for them.
DecodedDraco decode_draco(std::span<const unsigned char> stream, const DracoMesh& mesh);

}  // namespace zproof
