#include "filters/study/other_samplers.h"

#include <algorithm>
#include <vector>

#include "filters/reference/filter_peers.h"
#include "oracle/opengl.h"
#include "oracle/vulkan.h"

namespace zproof::study {
namespace {

using oracle::PeerFilter;

std::string never_absent() { return ""; }
std::string vulkan_absence() { return oracle::vulkan_is_missing().value_or(""); }
std::string opengl_absence() { return oracle::opengl_is_missing().value_or(""); }

oracle::FilterSettings settings_of(const texture::FilterOptions& options) {
    oracle::FilterSettings settings;
    settings.max_anisotropy = options.max_anisotropy;
    settings.samples = options.samples;
    settings.seed = options.seed;
    return settings;
}

template <PeerFilter filter>
Picture by_openimageio(const Scene& scene, const View& view, const Frame& frame,
                       const texture::FilterOptions& options) {
    return oracle::openimageio_filtered(scene, view, frame, filter, settings_of(options));
}

template <PeerFilter filter>
Picture by_opengl(const Scene& scene, const View& view, const Frame& frame,
                  const texture::FilterOptions& options) {
    return oracle::opengl_filtered(scene, view, frame, {filter, StepRule::analytic}, settings_of(options));
}

template <PeerFilter filter>
Picture by_vulkan(const Scene& scene, const View& view, const Frame& frame,
                  const texture::FilterOptions& options) {
    return oracle::vulkan_filtered(scene, view, frame,
                                   {filter, StepRule::analytic, options.max_anisotropy, options.mip_kernel});
}

texture::Method method(std::string name, texture::DefinitionCard card) {
    return {std::move(name), std::move(card), {}};
}

const std::string given_steps = "the steps to the neighbouring pixels, given in float32";
const std::vector<std::string> of_ratio{"max-anisotropy"}, of_chance{"max-anisotropy", "spp", "seed"},
    of_levels{"mip"}, of_both{"max-anisotropy", "mip"};

}  // namespace

std::span<const OtherSampler> other_samplers() {
    static const std::vector<OtherSampler> all{
        {method("oiio-trilinear", {.footprint = given_steps,
                                   .lod = "OpenImageIO's own; its definition is trilinear-oiio",
                                   .taps = "OpenImageIO's TextureSystem, MipModeTrilinear, as it is",
                                   .source = "OpenImageIO's library"}),
         never_absent, of_ratio, by_openimageio<PeerFilter::trilinear>},
        {method("oiio-aniso", {.footprint = given_steps,
                               .lod = "OpenImageIO's own; its definition is aniso-oiio",
                               .taps = "OpenImageIO's TextureSystem, MipModeAniso, as it is",
                               .source = "OpenImageIO's library"}),
         never_absent, of_ratio, by_openimageio<PeerFilter::anisotropic>},
        {method("oiio-stochastic-trilinear",
                {.footprint = given_steps,
                 .lod = "that of oiio-trilinear",
                 .taps = "The mean of spp lookups of oiio-trilinear with its attribute 'stochastic': each "
                         "reads one level, chosen by a number that is a hash of seed, pixel and sample",
                 .source = "OpenImageIO's library"}),
         never_absent, of_chance, by_openimageio<PeerFilter::stochastic_trilinear>},
        {method("oiio-stochastic-aniso",
                {.footprint = given_steps,
                 .lod = "that of oiio-aniso",
                 .taps = "The mean of spp lookups of oiio-aniso with its attribute 'stochastic': each reads "
                         "one level and one place, chosen by a number that is a hash of seed, pixel and "
                         "sample",
                 .source = "OpenImageIO's library"}),
         never_absent, of_chance, by_openimageio<PeerFilter::stochastic_anisotropic>},
        {method("opengl-trilinear",
                {.footprint = given_steps,
                 .lod = "the driver's own",
                 .taps = "OpenGL's sampler, GL_LINEAR_MIPMAP_LINEAR, as the driver has it",
                 .source = "the OpenGL driver of this machine"}),
         opengl_absence, of_ratio, by_opengl<PeerFilter::trilinear>},
        {method("opengl-aniso", {.footprint = given_steps,
                                 .lod = "the driver's own",
                                 .taps = "OpenGL's sampler, GL_TEXTURE_MAX_ANISOTROPY, as the driver has it",
                                 .source = "the OpenGL driver of this machine"}),
         opengl_absence, of_ratio, by_opengl<PeerFilter::anisotropic>},
        {method("vulkan-trilinear", {.footprint = given_steps,
                                     .lod = "the device's own",
                                     .taps = "Vulkan's sampler, linear within levels and between two, as the "
                                             "device has it",
                                     .source = "the Vulkan device of this machine"}),
         vulkan_absence, of_levels, by_vulkan<PeerFilter::trilinear>},
        {method("vulkan-aniso", {.footprint = given_steps,
                                 .lod = "the device's own",
                                 .taps = "Vulkan's sampler with anisotropyEnable, as the device has it",
                                 .source = "the Vulkan device of this machine"}),
         vulkan_absence, of_both, by_vulkan<PeerFilter::anisotropic>},
    };
    return all;
}

const OtherSampler* find_other_sampler(const std::string& name) {
    const std::span<const OtherSampler> all = other_samplers();
    const auto found =
        std::ranges::find(all, name, [](const OtherSampler& other) { return other.method.name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace zproof::study
