/// Texture filters of others, asked for the same picture that the filter reference judges
/// (docs/filter-peers.md): base colour factor x filtered texture, linear, black where nothing is seen.
#pragma once

#include "filters/reference/filter_reference.h"
#include "frame/frame.h"
#include "frame/picture.h"
#include "texture/method.h"

namespace zproof::oracle {

enum class PeerFilter {
    bilinear,                ///< level 0 alone
    trilinear,               ///< one place, two levels
    anisotropic,             ///< several places along the footprint's longer axis
    stochastic_trilinear,    ///< of OpenImageIO alone: one level, chosen by chance
    stochastic_anisotropic,  ///< the same: one level and one place
};

/// What OpenGL is asked for.
struct OpenGlFilter {
    PeerFilter filter;
    StepRule steps;
};

/// OpenGL's samplers: textures of float32 texels, its own glGenerateMipmap, GL_LINEAR_MIPMAP_LINEAR,
/// GL_TEXTURE_MAX_ANISOTROPY. Each pixel is given, in float32, the texture coordinates that it sees; steps
/// are handed over likewise (`analytic`, by textureGrad) or found by the driver (`quad_differences`). Throws
/// OracleError where there is no driver, or in the driver's words.
Picture opengl_filtered(const Scene& scene, const View& view, const Frame& frame, const OpenGlFilter& asked,
                        const FilterSettings& settings);
/// What the specification asks for leaves much open; this is declared: float32 coordinates and sums, 8 bits
/// of weights and of the LOD's fraction (Direct3D 11.3, 7.18.16: the least for hardware).
FilterPrecision opengl_filter_precision();

/// What Vulkan is asked for.
struct VulkanFilter {
    PeerFilter filter;  ///< trilinear or anisotropic
    StepRule steps;
    int max_anisotropy = 16;
    texture::MipKernel mip_kernel = texture::MipKernel::box;
};

/// A Vulkan device's samplers: levels of float32 texels that are made here, linear within and between them.
/// Coordinates and steps as OpenGL's. Throws OracleError where there is no device, or in its words.
Picture vulkan_filtered(const Scene& scene, const View& view, const Frame& frame, const VulkanFilter& asked);
/// Read from the device's limits (docs/vulkan.md): the preset vulkan-min with subTexelPrecisionBits and
/// mipmapPrecisionBits in the place of the least that Vulkan asks for.
FilterPrecision vulkan_filter_precision();

/// OpenImageIO's TextureSystem, with a mip chain made by its own make_texture (box) from the decoded float32
/// texels, bilinear interpolation and the conservative filter. It is given, in float32, the texture
/// coordinates and steps that each pixel of the frame sees. Of a stochastic filter it is the mean of
/// settings.samples lookups, each by a number that is a hash of settings.seed, pixel and sample. On the
/// threads of the surrounding tbb::task_arena. Throws OracleError in its words.
Picture openimageio_filtered(const Scene& scene, const View& view, const Frame& frame, PeerFilter filter,
                             const FilterSettings& settings);

}  // namespace zproof::oracle
