#include "filters/conformance/filter_precision_presets.h"
#include "filters/reference/filter_peers.h"
#include "filters/reference/picture_by_sampler.h"
#include "filters/stored/mip_chain.h"
#include "texture/linear_image.h"

namespace zproof::oracle {

Picture vulkan_filtered(const Scene& scene, const View& view, const Frame& frame, const VulkanFilter& asked) {
    return picture_by_sampler(
        scene, view, frame, [&](const Image& image, const Sampler& sampler, const TextureLookups& lookups) {
            texture::FilterOptions options;
            options.mip_kernel = asked.mip_kernel;
            const VulkanTexture texture{
                .levels = texture::mip_chain(
                    texture::linear_image({image.width, image.height, image.texels, image.light}), options),
                .wrap_u = sampler.wrap_u,
                .wrap_v = sampler.wrap_v,
                .max_anisotropy = asked.filter == PeerFilter::anisotropic ? float(asked.max_anisotropy) : 1};
            return vulkan_sampled(
                texture, lookups,
                asked.steps == StepRule::analytic ? Gradients::given : Gradients::of_the_device);
        });
}

FilterPrecision vulkan_filter_precision() {
    const VulkanDevice device = vulkan_devices().at(0);
    FilterPrecision promise = *preset_filter_precision("vulkan-min");
    promise.arithmetic_bits = FilterPrecision{}.arithmetic_bits;  // what leads to the places is ours
    promise.weight_bits = promise.tap_bits = device.subtexel_bits;
    promise.lod_bits = device.mipmap_bits;
    return promise;
}

}  // namespace zproof::oracle
