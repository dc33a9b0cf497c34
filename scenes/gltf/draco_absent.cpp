// Built where libdraco-dev is missing: the guard refuses such files before anything here is asked.
#include "scenes/gltf/draco.h"

namespace zproof {

bool has_draco() { return false; }

std::optional<std::uint64_t> draco_triangles(std::span<const unsigned char>) { return std::nullopt; }

DecodedDraco decode_draco(std::span<const unsigned char>, const DracoMesh&) {
    return {{}, {}, "this build has no decoder"};
}

}  // namespace zproof
