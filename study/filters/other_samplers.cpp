#include "study/filters/other_samplers.h"

#include <algorithm>
#include <vector>

#include "oracle/filter_peers.h"
#include "oracle/opengl.h"

namespace zproof::study {
namespace {

using oracle::PeerFilter;

std::string never_absent() { return ""; }
std::string opengl_absence() { return oracle::opengl_is_missing().value_or(""); }

oracle::FilterSettings settings(int max_anisotropy) {
    oracle::FilterSettings settings;
    settings.max_anisotropy = max_anisotropy;
    return settings;
}

template <PeerFilter filter>
Picture by_openimageio(const Scene& scene, const View& view, const Frame& frame, int max_anisotropy) {
    return oracle::openimageio_filtered(scene, view, frame, filter, settings(max_anisotropy));
}

template <PeerFilter filter>
Picture by_opengl(const Scene& scene, const View& view, const Frame& frame, int max_anisotropy) {
    return oracle::opengl_filtered(scene, view, frame, {filter, StepRule::analytic},
                                   settings(max_anisotropy));
}

texture::Method method(std::string name, texture::DefinitionCard card) {
    return {std::move(name), std::move(card), {}};
}

const std::string given_steps = "the steps to the neighbouring pixels, given in float32";

}  // namespace

std::span<const OtherSampler> other_samplers() {
    static const std::vector<OtherSampler> all{
        {method("oiio-trilinear", {.footprint = given_steps,
                                   .lod = "OpenImageIO's own; its definition is trilinear-oiio",
                                   .taps = "OpenImageIO's TextureSystem, MipModeTrilinear, as it is",
                                   .source = "OpenImageIO's library"}),
         never_absent, by_openimageio<PeerFilter::trilinear>},
        {method("oiio-aniso", {.footprint = given_steps,
                               .lod = "OpenImageIO's own; its definition is aniso-oiio",
                               .taps = "OpenImageIO's TextureSystem, MipModeAniso, as it is",
                               .source = "OpenImageIO's library"}),
         never_absent, by_openimageio<PeerFilter::anisotropic>},
        {method("opengl-trilinear",
                {.footprint = given_steps,
                 .lod = "the driver's own",
                 .taps = "OpenGL's sampler, GL_LINEAR_MIPMAP_LINEAR, as the driver has it",
                 .source = "the OpenGL driver of this machine"}),
         opengl_absence, by_opengl<PeerFilter::trilinear>},
        {method("opengl-aniso", {.footprint = given_steps,
                                 .lod = "the driver's own",
                                 .taps = "OpenGL's sampler, GL_TEXTURE_MAX_ANISOTROPY, as the driver has it",
                                 .source = "the OpenGL driver of this machine"}),
         opengl_absence, by_opengl<PeerFilter::anisotropic>},
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
