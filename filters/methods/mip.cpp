#include <cmath>

#include "filters/methods/bilinear_rule.h"
#include "filters/methods/families.h"
#include "filters/stored/weighted_chain.h"

namespace zproof::texture {

namespace {

/// The level nearest to the LOD, read alone.
enum class Within { nearest, bilinear };

template <Within within>
struct NearestLevel {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const int level = nearest_level(mips.in_chain(lod_gl_maximum(footprint)));
        if constexpr (within == Within::nearest)
            mips.nearest(level, footprint.centre, 1, read);
        else
            mips.bilinear(level, footprint.centre, 1, read);
    }
};

/// One tap, in the middle.
template <LodRule lod>
struct Trilinear {
    static constexpr reads::TapSpacing spacing{};

    LineOfTaps line(const MipReads& mips, const Footprint& footprint) const {
        return {.lod = mips.in_chain(lod(footprint))};
    }
};

/// trilinear-gl, its LOD's fraction twice as steep about 1/2 and cut off: half of every octave is one level.
struct Brilinear {
    static constexpr reads::TapSpacing spacing{};

    LineOfTaps line(const MipReads& mips, const Footprint& footprint) const {
        const double lod = mips.in_chain(lod_gl_maximum(footprint)), finer = std::floor(lod);
        return {.lod = finer + std::clamp(2 * (lod - finer) - 0.5, 0.0, 1.0)};
    }
};

/// trilinear-gl on a chain weighed by the surface. Negative weights of areas may sum to nothing, so there is
/// no chain of this kind by a windowed sinc.
Sampler prepare_parameterization_aware(const LinearImage& image, const FilterOptions& options) {
    FilterOptions own = options;
    if (own.mip_kernel == MipKernel::lanczos3 || own.mip_kernel == MipKernel::kaiser3)
        own.mip_kernel = MipKernel::polyphase;
    const std::vector<double> weights =
        own.surface ? texel_weights(own.surface(), image.width, image.height) : std::vector<double>{};
    if (own.given_levels || weights.empty()) return prepare_bilinear<Trilinear<lod_gl_maximum>>(image, own);
    const WeightedChain chain{image, weights, own.mip_kernel};
    own.given_levels = std::make_shared<const std::vector<LinearImage>>(chain.smaller());
    Sampler sampler = prepare_bilinear<Trilinear<lod_gl_maximum>>(image, own);
    sampler.stored = chain.stored();
    return sampler;
}

Method nearest_level_method(std::string name, std::string taps, decltype(Method::prepare) prepare) {
    return {
        .name = std::move(name),
        .card = {.footprint = "The longer of the pixel's two steps.",
                 .lod = "log2 of its length in texels, biased, clamped; the level is ceil(LOD + 1/2) - 1.",
                 .taps = std::move(taps),
                 .source = "OpenGL 4.6 core, 8.14"},
        .prepare = std::move(prepare)};
}

Method trilinear_method(std::string name, DefinitionCard card, decltype(Method::prepare) prepare) {
    card.taps = "Bilinear in the two levels around the LOD, weighted by its fraction.";
    return {.name = std::move(name), .card = std::move(card), .prepare = std::move(prepare)};
}

}  // namespace

std::vector<Method> mip_methods() {
    return {
        nearest_level_method("mip-nearest-point", "The texel of that level that holds the place.",
                             prepare_mipped<NearestLevel<Within::nearest>>),
        nearest_level_method("mip-nearest-bilinear",
                             "The four texels of that level whose centres surround the place.",
                             prepare_bilinear<NearestLevel<Within::bilinear>>),
        trilinear_method("trilinear-gl",
                         {.footprint = "The longer of the pixel's two steps.",
                          .lod = "log2 of its length in texels.",
                          .taps = {},
                          .source = "OpenGL 4.6 core, 8.14; Williams 1983"},
                         prepare_bilinear<Trilinear<lod_gl_maximum>>),
        trilinear_method("trilinear-ellipse",
                         {.footprint = "The ellipse that the Jacobian makes of the unit circle.",
                          .lod = "log2 of its longer semi-axis, the Jacobian's larger singular value s1.",
                          .taps = {},
                          .source = "Direct3D 11.3 functional specification, 7.18.11"},
                         prepare_bilinear<Trilinear<lod_ellipse_major>>),
        trilinear_method(
            "trilinear-rms",
            {.footprint = "Both of the pixel's steps, equally.",
             .lod = "log2 of the root mean square of their lengths, sqrt((|per_x|^2 + |per_y|^2) / 2).",
             .taps = {},
             .source = "ours; no publication found that gives it a name"},
            prepare_bilinear<Trilinear<lod_root_mean_square>>),
        trilinear_method("trilinear-area",
                         {.footprint = "The parallelogram of the pixel's two steps.",
                          .lod = "log2 of the square root of its area, |det J|.",
                          .taps = {},
                          .source = "common in lectures on texture mapping"},
                         prepare_bilinear<Trilinear<lod_area>>),
        trilinear_method(
            "trilinear-pbrt",
            {.footprint = "The Jacobian's largest absolute entry.",
             .lod =
                 "1 + log2 of it. pbrt measures in texture coordinates of a square texture; here each entry "
                 "is in texels of its own axis.",
             .taps = {},
             .source = "pbrt-v4, MIPMap::Filter"},
            prepare_bilinear<Trilinear<lod_pbrt>>),
        trilinear_method(
            "trilinear-ray-cone",
            {.footprint =
                 "The cone about the pixel's ray d. Its spread angle is alpha = atan(p), p: the image "
                 "plane's "
                 "height at depth 1 by the image's rows. At the distance t of the surface it is w = 2 t "
                 "tan(alpha / 2) wide. Of a parallel projection w is the height of a pixel.",
             .lod =
                 "log2(w sqrt(t_a / p_a) / |n . d|), t_a: the triangle's area in texels of level 0, p_a: its "
                 "area in the world, n: its unit normal.",
             .taps = {},
             .source = "Akenine-Moller, Nilsson, Andersson, Barre-Brisebois, Toth and Karras 2019; "
                       "Akenine-Moller, Crassin, Boksansky, Belcour, Panteleev and Wright 2021, with its "
                       "erratum"},
            prepare_bilinear<Trilinear<lod_ray_cone>>),
        {.name = "brilinear",
         .card = {.footprint = "The longer of the pixel's two steps.",
                  .lod = "log2 of its length in texels, biased, clamped. Its fraction f then becomes "
                         "min(max(2 f - 1/2, 0), 1).",
                  .taps = "Bilinear in the two levels around that LOD, weighted by its fraction: one level "
                          "alone where the LOD is within 1/4 of a whole number.",
                  .source = "Mesa, llvmpipe, lp_build_brilinear_lod of factor 2; a habit of graphics cards "
                            "since 2003"},
         .prepare = prepare_bilinear<Brilinear>},
        {.name = "trilinear-parameterization-aware",
         .card = {.footprint = "The longer of the pixel's two steps.",
                  .lod = "log2 of its length in texels.",
                  .taps =
                      "As trilinear-gl, of a chain that weighs each texel by the area of the surface that "
                      "it covers in the world. Where no surface is known it is trilinear-gl.",
                  .source = "Manson and Schaefer 2012, Parameterization-Aware MIP-Mapping: their weights by "
                            "area, without their least squares for the filter that the hardware applies"},
         .prepare = prepare_parameterization_aware}};
}

}  // namespace zproof::texture
