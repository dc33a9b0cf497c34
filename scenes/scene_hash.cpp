#include "scenes/scene_hash.h"

#include <bit>
#include <span>

#include "math/sha256.h"

namespace zproof {

// What lies in memory is what the hash is defined over.
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::uvec3) == 12);

std::string sha256_of(const Scene& scene) {
    const Positions& positions = scene.vertices.position_world;
    Sha256 sum;
    sum.add("zproof scene 1\n");
    sum.add(std::uint64_t{positions.size()});
    sum.add(std::as_bytes(std::span{positions.data(), positions.size()}));
    sum.add(std::uint64_t{scene.triangles.size()});
    sum.add(std::as_bytes(std::span{scene.triangles}));
    return sum.hex();
}

}  // namespace zproof
