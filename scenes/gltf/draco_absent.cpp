// Built where libdraco-dev is missing: such files are refused before anything here is asked.
#include "scenes/gltf/decoders.h"

namespace zproof {

bool has_draco() { return false; }

std::optional<std::uint64_t> draco_triangles(std::span<const unsigned char>) { return std::nullopt; }

DecodedDraco decode_draco(std::span<const unsigned char>, const DracoMesh&) {
    return {{}, {}, "this build has no decoder"};
}

}  // namespace zproof
