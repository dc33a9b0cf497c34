#include <algorithm>
#include <cmath>
#include <tuple>

#include "filters/selftest/likely_cause.h"
#include "math/srgb.h"

namespace zproof::selftest {

namespace {

using Changes = std::vector<DefinitionChange>;
using oracle::FilterSettings;
using oracle::filter_reference::Decoding;

void on_textures(Scene& scene, const std::function<void(Texture&)>& change) {
    for (Material& material : scene.materials)
        if (material.base_color.image != Texture::none) change(material.base_color);
}

void two_bits_fewer(FilterClaim& claim) {
    claim.precision.colour_bits = std::min(claim.precision.colour_bits, 22.0);
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

/// The picture itself is right, and something was done with it.
using Undone = std::function<std::optional<LinearRgb>(const Picture&, int x, int y)>;

/// The picture's pixel stands elsewhere: `place` says where.
Undone from(const std::function<FilterPixel(FilterPixel, Resolution)>& place) {
    return [place](const Picture& picture, int x, int y) -> std::optional<LinearRgb> {
        const auto [at_x, at_y] = place({x, y}, picture.size());
        if (at_x < 0 || at_y < 0 || at_x >= picture.size().width || at_y >= picture.size().height)
            return std::nullopt;
        return picture.at(at_x, at_y);
    };
}

Undone by_channel(double (*undone)(double)) {
    return [undone](const Picture& picture, int x, int y) -> std::optional<LinearRgb> {
        const auto& [r, g, b] = picture.at(x, y);
        return LinearRgb{float(undone(double{r})), float(undone(double{g})), float(undone(double{b}))};
    };
}

void add_pictures(Changes& all) {
    const auto add = [&](const char* name, const Undone& undone) {
        all.push_back({.name = name, .of_picture = undone});
    };
    add("the picture is upside down", from([](FilterPixel p, Resolution r) {
            return FilterPixel{p.x, r.height - 1 - p.y};
        }));
    add("left and right are exchanged", from([](FilterPixel p, Resolution r) {
            return FilterPixel{r.width - 1 - p.x, p.y};
        }));
    add("the picture is turned by 180 degrees", from([](FilterPixel p, Resolution r) {
            return FilterPixel{r.width - 1 - p.x, r.height - 1 - p.y};
        }));
    for (const auto& [name, x, y] : {std::tuple{"a pixel to the right", 1, 0},
                                     {"a pixel to the left", -1, 0},
                                     {"a pixel down", 0, 1},
                                     {"a pixel up", 0, -1}})
        all.push_back({.name = std::string{"the picture lies "} + name,
                       .of_picture = from([dx = x, dy = y](FilterPixel p, Resolution) {
                           return FilterPixel{p.x + dx, p.y + dy};
                       })});
    add("red and blue are exchanged", [](const Picture& picture, int x, int y) -> std::optional<LinearRgb> {
        const auto& [r, g, b] = picture.at(x, y);
        return LinearRgb{b, g, r};
    });
}

/// What the last step did to values rounds them elsewhere: two bits of the picture are let go.
void add_curves(Changes& all) {
    const auto add = [&](const char* name, double (*undone)(double)) {
        all.push_back({.name = name, .of_claim = two_bits_fewer, .of_picture = by_channel(undone)});
    };
    all.push_back({.name = "values are rounded to 8-bit sRGB codes",
                   .of_claim = [](FilterClaim& c) { c.precision.code_error = 0.5; }});
    add("values are sRGB codes", decoded_srgb);
    add("values are raised to 1 / 2.2", [](double v) { return std::pow(v, 2.2); });
    add("values are decoded from sRGB once more", encoded_srgb);
    add("values are raised to 2.2", [](double v) { return std::pow(v, 1 / 2.2); });
}

/// Pixels are seen through a corner or the middle of an edge: the window moves by half a pixel.
void add_samples(Changes& all) {
    for (const auto& [name, x, y] :
         {std::tuple{"pixels are seen through their upper left corners", -0.5, -0.5},
          {"pixels are seen through their lower right corners", 0.5, 0.5}})
        all.push_back({.name = name, .of_view = [dx = x, dy = y](View& view) {
                           Window& w = view.camera.window;
                           const double across = dx * (w.right - w.left) / view.width,
                                        down = dy * (w.top - w.bottom) / view.height;
                           w.left += across, w.right += across, w.top -= down, w.bottom -= down;
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
    all.push_back({.name = "reads do not cross the texture's seams",
                   .of_reference = [](FilterSettings& s) { s.wrap.ends_at_seams = true; }});
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

/// Sums of boxes, by the table's columns and rows.
void add_sums(Changes& all) {
    for (const auto& [name, columns, rows] : {std::tuple{"boxes end a column too late", 1, 0},
                                              {"boxes end a column too early", -1, 0},
                                              {"boxes end a row too late", 0, 1},
                                              {"boxes end a row too early", 0, -1},
                                              {"boxes end a column and a row too late", 1, 1},
                                              {"boxes end a column and a row too early", -1, -1}})
        all.push_back({.name = name, .of_reference = [more = glm::ivec2{columns, rows}](FilterSettings& s) {
                           s.more_texels = more;
                       }});
}

/// Codes are no float32s, and light made of them is rounded elsewhere.
void add_decodings(Changes& all) {
    for (const auto& [decoding, name] :
         {std::pair{Decoding::after_filtering, "sRGB is decoded after filtering"},
          {Decoding::never, "sRGB is not decoded"},
          {Decoding::twice, "sRGB is decoded twice"}})
        all.push_back({.name = name,
                       .of_claim = two_bits_fewer,
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
    if (claim.method.starts_with("sat-")) add_sums(all);
    add_pictures(all);
    add_curves(all);
    add_samples(all);
    add_methods(all, claim);
    return all;
}

}  // namespace zproof::selftest
