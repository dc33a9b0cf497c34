// Built where libmeshoptimizer-dev is missing: such files are refused before anything here is asked.
#include "scenes/gltf/decoders.h"

namespace zproof {

bool has_meshopt() { return false; }

std::string fault_of(const MeshoptView&) { return "this build has no decoder"; }

bool decode_meshopt(const MeshoptView&, std::span<const unsigned char>, std::span<unsigned char>) {
    return false;
}

}  // namespace zproof
