#include "filters/selftest/likely_cause.h"

#include <algorithm>
#include <cmath>

#include "frame/joined.h"

namespace zproof::selftest {

namespace {

using Changes = std::vector<DefinitionChange>;
using oracle::FilterSettings;
using oracle::filter_reference::Decoding;

void on_textures(Scene& scene, const std::function<void(Texture&)>& change) {
    for (Material& material : scene.materials)
        if (material.base_color.image != Texture::none) change(material.base_color);
}

void add_places(Changes& all) {
    for (const double far : {0.5, 1.0}) {
        const std::string name = far == 1 ? "a texel" : "half a texel";
        for (const double sign : {1.0, -1.0}) {
            const std::string which = sign < 0 ? " against " : " along ";
            all.push_back(moved_place("places " + name + which + "u", {sign * far, 0}));
            all.push_back(moved_place("places " + name + which + "v", {0, sign * far}));
            all.push_back(moved_place("places " + name + which + "u and v", {sign * far, sign * far}));
        }
    }
    for (const auto& [texels, name] : {std::pair{0.5, "places half a texel of each level along u and v"},
                                       {-0.5, "places half a texel of each level against u and v"}})
        all.push_back(
            {.name = name, .of_claim = [t = texels](FilterClaim& c) { c.precision.level_offset = t; }});
    all.push_back(moved_place("places half a texel along u, against v", {0.5, -0.5}));
    all.push_back(moved_place("places half a texel against u, along v", {-0.5, 0.5}));
}

/// Coordinates of the texture as a whole, 0 to 1 across it.
DefinitionChange turned(const char* name, const glm::dmat2& linear, const glm::dvec2& translation) {
    return {.name = name, .of_scene = [=](Scene& scene) {
                on_textures(scene, [&](Texture& texture) {
                    UvTransform& t = texture.transform;
                    t = {linear * t.linear, translation + linear * t.translation};
                });
            }};
}

void add_transforms(Changes& all, const Scene& scene) {
    all.push_back(turned("v runs upwards", {1, 0, 0, -1}, {0, 1}));
    all.push_back(turned("u runs backwards", {-1, 0, 0, 1}, {1, 0}));
    all.push_back(turned("u runs backwards and v upwards", {-1, 0, 0, -1}, {1, 1}));
    all.push_back(turned("u and v are exchanged", {0, 1, 1, 0}, {0, 0}));
    const auto is_turned = [](const Material& material) {
        const UvTransform& t = material.base_color.transform;
        return t.linear != glm::dmat2{1} || t.translation != glm::dvec2{0};
    };
    if (std::ranges::any_of(scene.materials, is_turned))
        all.push_back({.name = "the texture's transform is ignored", .of_scene = [](Scene& changed) {
                           on_textures(changed, [](Texture& texture) { texture.transform = {}; });
                       }});
}

void add_wraps(Changes& all) {
    constexpr std::array<std::pair<Wrap, const char*>, 3> wraps{
        {{Wrap::repeat, "repeat"}, {Wrap::clamp_to_edge, "clamp"}, {Wrap::mirrored_repeat, "mirror"}}};
    for (const auto& [wrap_u, u] : wraps)
        for (const auto& [wrap_v, v] : wraps)
            all.push_back({.name = std::string{"wraps are "} + u + " along u and " + v + " along v",
                           .of_scene = [along_u = wrap_u, along_v = wrap_v](Scene& scene) {
                               on_textures(scene, [&](Texture& texture) {
                                   texture.sampler.wrap_u = along_u, texture.sampler.wrap_v = along_v;
                               });
                           }});
}

void add_levels(Changes& all) {
    for (const auto& [levels, words] : {std::pair{0.5, "half a level"}, {1.0, "a level"}}) {
        all.push_back(biased_lod(std::string{"LOD "} + words + " too high", levels));
        all.push_back(biased_lod(std::string{"LOD "} + words + " too low", -levels));
    }
    for (int last = 0; last <= 10; ++last)
        all.push_back({.name = "no level above " + std::to_string(last), .of_claim = [last](FilterClaim& c) {
                           c.options.lod_max = std::min(c.options.lod_max, double(last));
                       }});
    constexpr std::array<std::pair<texture::MipKernel, const char*>, 4> kernels{
        {{texture::MipKernel::box, "box"},
         {texture::MipKernel::polyphase, "polyphase"},
         {texture::MipKernel::lanczos3, "lanczos3"},
         {texture::MipKernel::kaiser3, "kaiser3"}}};
    for (const auto& [kernel, name] : kernels)
        all.push_back({.name = std::string{"levels by "} + name,
                       .of_claim = [k = kernel](FilterClaim& c) { c.options.mip_kernel = k; }});
}

void add_steps(Changes& all) {
    using enum StepRule;
    for (const auto& [steps, name] :
         {std::pair{analytic, "steps are derivatives"},
          {quad_differences, "steps are differences within 2 x 2 pixels"},
          {forward_differences, "steps are differences to the next pixel"},
          {centred_differences, "steps are differences across the pixel"},
          {wrapped_quad_differences,
           "coordinates are wrapped before they are differenced within 2 x 2 pixels"},
          {wrapped_forward_differences, "coordinates are wrapped before the next pixel's are differenced"},
          {wrapped_centred_differences,
           "coordinates are wrapped before they are differenced across the pixel"}})
        all.push_back({.name = name, .steps = steps});
}

void add_taps(Changes& all, const FilterClaim& claim) {
    for (const int limit : {1, 2, 4, 8, 16, 32, 64})
        if (limit != claim.options.max_anisotropy)
            all.push_back({.name = "the limit of anisotropy is " + std::to_string(limit),
                           .of_claim = [limit](FilterClaim& c) { c.options.max_anisotropy = limit; }});
    all.push_back({.name = "one tap too many", .of_reference = [](FilterSettings& s) { s.more_taps = 1; }});
}

/// Codes are no float32s and light made of them is rounded elsewhere: two bits of the picture are let go.
void add_decodings(Changes& all) {
    for (const auto& [decoding, name] :
         {std::pair{Decoding::after_filtering, "sRGB is decoded after filtering"},
          {Decoding::never, "sRGB is not decoded"},
          {Decoding::twice, "sRGB is decoded twice"}})
        all.push_back(
            {.name = name,
             .of_claim =
                 [](FilterClaim& c) { c.precision.colour_bits = std::min(c.precision.colour_bits, 22.0); },
             .of_reference = [d = decoding](FilterSettings& s) { s.decoding = d; }});
}

void add_methods(Changes& all, const FilterClaim& claim) {
    for (const auto& definition : oracle::filter_definitions())
        if (definition.name != claim.method && !definition.draws)
            all.push_back({.name = "it is " + definition.name,
                           .of_claim = [name = definition.name](FilterClaim& c) { c.method = name; }});
}

}  // namespace

std::vector<DefinitionChange> likely_changes(const Scene& scene, const FilterClaim& claim) {
    Changes all;
    add_places(all);
    add_transforms(all, scene);
    add_wraps(all);
    add_levels(all);
    add_steps(all);
    add_taps(all, claim);
    add_decodings(all);
    add_methods(all, claim);
    return all;
}

std::vector<std::string> causes_of(const Picture& picture, const ChangedDefinitions& definitions,
                                   const FilterClaim& claim, const Conformance& found,
                                   const std::vector<DefinitionChange>& changes) {
    const std::vector<FilterPixel> wrong = some_pixels(found, std::nextafter(1.0f, 2.0f));
    if (wrong.empty()) return {};
    std::vector<std::string> names;
    for (const DefinitionChange& change : changes) {
        const PixelReference reference = definitions.under(change);
        const FilterPrecision precision = claim_under(change, claim).precision;
        const auto is_permitted = [&](const FilterPixel& p) {
            return slack_of(picture.at(p.x, p.y), reference(p.x, p.y, precision)) <= 1;
        };
        if (!is_permitted(found.worst) || !std::ranges::all_of(wrong, is_permitted)) continue;
        if (!have_pixels_outside({&picture, 1}, reference, precision)[0]) names.push_back(change.name);
    }
    return names;
}

std::string causes_in_words(const std::vector<std::string>& causes) {
    return causes.empty() ? "" : "; cause: " + joined(causes, ", or ");
}

}  // namespace zproof::selftest
