#include "texture/method.h"

#include <cassert>

namespace zproof::texture {

void look_up(const Sampler& sampler, std::span<const Footprint> seen, std::span<glm::dvec4> colours) {
    assert(seen.size() == colours.size());
    if (sampler.colours) return sampler.colours(seen, colours);
    for (std::size_t i = 0; i < seen.size(); ++i) colours[i] = sampler.colour(seen[i]);
}

}  // namespace zproof::texture
