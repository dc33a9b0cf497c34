/// A Vulkan device's texture unit: what its sampler gives for places that it is handed.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "frame/plane.h"
#include "oracle/vulkan.h"
#include "scenes/scene.h"
#include "texture/linear_image.h"

namespace zproof::oracle {

/// Read bilinearly from both levels beside the LOD.
struct VulkanTexture {
    std::vector<texture::LinearImage> levels;  ///< float32 RGBA, each half the size of the one before
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    float max_anisotropy = 1;  ///< 1: not asked for
};

/// Where the steps to the neighbouring pixels come from.
enum class Gradients {
    given,          ///< textureGrad
    of_the_device,  ///< texture: differences within 2 x 2 pixels
};

/// What each pixel hands to the sampler.
struct TextureLookups {
    Plane<glm::vec4> place;  ///< uv
    Plane<glm::vec4> steps;  ///< of uv per x, and per y; of no matter to `of_the_device`
};

/// RGBA of each pixel. Throws OracleError where vulkan_is_missing() gives a reason, and where the device
/// cannot read such a texture linearly.
Plane<glm::vec4> vulkan_sampled(const VulkanTexture& texture, const TextureLookups& lookups,
                                Gradients gradients);

}  // namespace zproof::oracle
