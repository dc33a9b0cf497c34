/// Decoders of compressed meshes: buffer views that meshoptimizer compressed (EXT_meshopt_compression), and
/// meshes that Draco compressed (KHR_draco_mesh_compression).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scenes/scene_files.h"

namespace zproof {

/// What the extension says of one buffer view; the numbers are checked integers below 2^31.
struct MeshoptView {
    int buffer = -1;
    std::size_t offset = 0, bytes = 0;  ///< where the stream lies in it
    std::size_t stride = 0, count = 0;
    std::string mode, filter;  ///< "ATTRIBUTES", "TRIANGLES", "INDICES"; "NONE", "OCTAHEDRAL", ...
};

/// Whether this build has the decoder of meshoptimizer.
bool has_meshopt();

/// Why the extension forbids the combination, or nothing.
std::string fault_of(const MeshoptView& view);

/// Decodes a stream into stride x count bytes. The view is without fault. False where the stream is broken.
bool decode_meshopt(const MeshoptView& view, std::span<const unsigned char> stream,
                    std::span<unsigned char> to);

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
    std::vector<std::uint32_t> indices;  ///< in the decoder's order
    std::vector<Bytes> attributes;       ///< tightly packed, as DracoMesh lists them
    std::string fault;                   ///< why there is nothing else; empty: all is there
};

/// Whether this build has the decoder of Draco.
bool has_draco();

/// The number of triangles that the stream's header states; none where it has no such header.
std::optional<std::uint64_t> draco_triangles(std::span<const unsigned char> stream);

/// Decodes a stream. Counts are compared with what the file says before the decoder allocates for them.
DecodedDraco decode_draco(std::span<const unsigned char> stream, const DracoMesh& mesh);

}  // namespace zproof
