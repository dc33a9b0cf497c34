#include <cmath>

#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"

namespace zproof::selftest {

texture::Method distorted(const texture::Method& method, const Distortion& distortion) {
    texture::Method wrong = method;
    wrong.prepare = [method, distortion](const texture::LinearImage& image,
                                         const texture::FilterOptions& options) {
        texture::Sampler told;
        told.colour = [sampler = method.prepare(image, options), distortion,
                       size = glm::dvec2{image.width, image.height}](const Footprint& f) {
            return sampler.colour(distortion(f, size));
        };
        return told;
    };
    return wrong;
}

namespace {

using rasterizer::Texturing;
using texture::FilterOptions;
using Inject = std::function<Picture(const FilterFixture&, const Texturing&)>;

Picture drawn(const FilterFixture& fixture, const Texturing& texturing) {
    return rasterizer::filtered(fixture.scene, fixture.view, fixture.frame, texturing);
}

/// The right method, told something wrong of the pixel.
Inject told(const Distortion& distortion) {
    return [distortion](const FilterFixture& fixture, const Texturing& right) {
        const texture::Method wrong = distorted(right.method, distortion);
        return drawn(fixture, {.method = wrong, .options = right.options});
    };
}

/// Another method, the same options.
Inject by(const texture::Method& wrong) {
    return [wrong](const FilterFixture& fixture, const Texturing& right) {
        return drawn(fixture, {.method = wrong, .options = right.options});
    };
}
Inject by(const char* name) { return by(*texture::find_method(name)); }

/// The right method, other options.
Inject set(const std::function<void(FilterOptions&)>& change) {
    return [change](const FilterFixture& fixture, const Texturing& right) {
        Texturing wrong = right;
        change(wrong.options);
        return drawn(fixture, wrong);
    };
}

/// The right method, told of other surfaces that show the texture.
Inject showing(const std::function<void(std::vector<texture::SurfaceTriangle>&)>& change) {
    return [change](const FilterFixture& fixture, const Texturing& right) {
        texture::Method wrong = right.method;
        wrong.prepare = [change, right](const texture::LinearImage& image, FilterOptions options) {
            options.surface = [change, surface = options.surface] {
                std::vector<texture::SurfaceTriangle> all = surface();
                change(all);
                return all;
            };
            return right.method.prepare(image, options);
        };
        return drawn(fixture, {.method = wrong, .options = right.options});
    };
}

/// The right method of another scene.
Inject of(const std::function<void(Scene&)>& change) {
    return [change](const FilterFixture& fixture, const Texturing& right) {
        FilterFixture wrong = fixture;
        change(wrong.scene);
        return drawn(wrong, right);
    };
}

/// The right picture, spoiled.
Inject afterwards(const std::function<LinearRgb(const LinearRgb&)>& change) {
    return [change](const FilterFixture& fixture, const Texturing& right) {
        Picture picture = drawn(fixture, right);
        for (LinearRgb& pixel : picture.pixels()) pixel = change(pixel);
        return picture;
    };
}

Distortion shifted(double u, double v) {
    return [=](Footprint f, const glm::dvec2&) {
        f.centre += glm::dvec2{u, v};
        return f;
    };
}

Distortion steps_by(double factor) {
    return [=](Footprint f, const glm::dvec2&) {
        f.per_x *= factor, f.per_y *= factor;
        return f;
    };
}

glm::dvec2 rounded(const glm::dvec2& p, double steps) { return glm::round(p * steps) / steps; }

/// The difference of coordinates that were brought into [0, size) first.
Footprint wrapped_before_differencing(Footprint f, const glm::dvec2& size) {
    const auto wrapped_at = [&](double dx, double dy) {
        const glm::dvec2 place = f.at(f.centre_raster + glm::dvec2{dx, dy}) / size;
        return (place - glm::floor(place)) * size;
    };
    f.per_x = wrapped_at(0.5, 0) - wrapped_at(-0.5, 0);
    f.per_y = wrapped_at(0, 0.5) - wrapped_at(0, -0.5);
    return f;
}

Distortion cones_by(double factor) {
    return [=](Footprint f, const glm::dvec2&) {
        f.cone.along *= factor, f.cone.across *= factor;
        return f;
    };
}

Footprint at_the_pixels_corner(Footprint f, const glm::dvec2&) {
    f.centre_raster -= 0.5;
    f.centre = f.at(f.centre_raster);
    return f;
}

std::vector<FilterFault> faults_of_places() {
    return {
        {"half_texel_right", "texel centres lie at whole numbers: half a texel to the right", "bilinear",
         told(shifted(0.5, 0))},
        {"half_texel_nearest", "the nearest texel is found by rounding instead of by floor", "nearest",
         told(shifted(0.5, 0.5))},
        {"a_thousandth_of_a_texel", "the place is off by a thousandth of a texel", "trilinear-gl",
         told(shifted(0.001, 0))},
        {"place_in_256ths", "the place is rounded to 8 sub-texel bits", "bilinear",
         told([](Footprint f, const glm::dvec2&) {
             f.centre = rounded(f.centre, 256);
             return f;
         })},
        // One coordinate alone: g++ 12.2 vectorises a pair of double -> float -> double into nothing at all.
        {"coordinate_in_float32", "u is held in float32", "bilinear",
         told([](Footprint f, const glm::dvec2& size) {
             f.centre.x = double{float(f.centre.x / size.x)} * size.x;
             return f;
         })},
        {"sampled_at_the_corner", "the pixel is sampled at its upper left corner", "trilinear-gl",
         told(at_the_pixels_corner)},
        {"v_flipped", "v runs upwards", "trilinear-gl", told([](Footprint f, const glm::dvec2& size) {
             f.centre.y = size.y - f.centre.y;
             return f;
         })},
        {"u_and_v_exchanged", "u and v are exchanged", "trilinear-gl",
         told([](Footprint f, const glm::dvec2&) {
             std::swap(f.centre.x, f.centre.y);
             return f;
         })},
        {"affine_uv", "texture coordinates are interpolated without regard to perspective", "trilinear-gl",
         [](const FilterFixture& fixture, const Texturing& right) {
             return drawn(fixture, {.method = right.method,
                                    .options = right.options,
                                    .uv = rasterizer::UvInterpolation::affine});
         }},
        {"clamp_for_repeat", "the texture is clamped where it should repeat", "trilinear-gl",
         of([](Scene& s) { s.materials[0].base_color.sampler.wrap_u = Wrap::clamp_to_edge; })},
        {"repeat_for_mirror",
         "the texture repeats where it should be mirrored",
         "aniso-midpoint",
         of([](Scene& s) { s.materials[0].base_color.sampler.wrap_u = Wrap::repeat; }),
         {},
         Ground::mirrored},
        {"transform_ignored",
         "the material's texture transform is ignored",
         "trilinear-gl",
         of([](Scene& s) { s.materials[0].base_color.transform = {}; }),
         {},
         Ground::turned}};
}

std::vector<FilterFault> faults_of_steps() {
    return {
        {"wrapped_derivative", "coordinates are wrapped before they are differenced", "trilinear-gl",
         told(wrapped_before_differencing)},
        {"radius_for_diameter", "the footprint is taken half as large", "sat-affine", told(steps_by(0.5))},
        {"diameter_for_radius", "the ellipse is taken twice as large", "ewa-pbrt-table", told(steps_by(2))},
        {"derivatives_exchanged", "the steps' u and v are exchanged", "aniso-midpoint",
         told([](Footprint f, const glm::dvec2&) {
             std::swap(f.per_x.x, f.per_x.y), std::swap(f.per_y.x, f.per_y.y);
             return f;
         })},
        {"derivative_sign", "the step down has the wrong sign in u", "aniso-d3d11",
         told([](Footprint f, const glm::dvec2&) {
             f.per_y.x = -f.per_y.x;
             return f;
         })},
        {"step_down_forgotten", "only the step to the right counts", "trilinear-gl",
         told([](Footprint f, const glm::dvec2&) {
             f.per_y = {0, 0};
             return f;
         })},
        {"width_for_height",
         "v steps are measured in texels of the width",
         "trilinear-gl",
         told([](Footprint f, const glm::dvec2& size) {
             f.per_x.y *= size.x / size.y, f.per_y.y *= size.x / size.y;
             return f;
         }),
         {},
         Ground::odd_sizes},
        {"cone_by_its_whole_angle", "the cone's width is 2 t tan(alpha) instead of 2 t tan(alpha / 2)",
         "trilinear-ray-cone", told(cones_by(2))},
        {"gradients_of_half_the_axes", "g1 and g2 are the gradients instead of 2 g1 and 2 g2",
         "aniso-ray-cone", told(cones_by(0.5))},
        {"root_of_the_cosine", "the cone's LOD has the root of the cosine", "trilinear-ray-cone",
         told([](Footprint f, const glm::dvec2&) {
             f.cone.cosine = 1;
             return f;
         })},
        {"differences_for_derivatives",
         "steps are differences within 2 x 2 pixels, although exact ones are promised", "trilinear-gl",
         [](const FilterFixture& fixture, const Texturing& right) {
             return drawn(fixture, {.method = right.method,
                                    .options = right.options,
                                    .derivatives = texture::Derivatives::quad_differences});
         }}};
}

std::vector<FilterFault> faults_of_levels() {
    return {{"lod_one_too_large", "every LOD is one too large", "trilinear-gl",
             set([](FilterOptions& o) { o.lod_bias += 1; })},
            {"lod_one_too_small", "every LOD is one too small", "trilinear-ellipse",
             set([](FilterOptions& o) { o.lod_bias -= 1; })},
            {"lod_a_256th_off", "every LOD is 1/256 too large", "trilinear-gl",
             set([](FilterOptions& o) { o.lod_bias += 1.0 / 256; })},
            {"shorter_step", "the LOD is that of the shorter step", "trilinear-gl",
             told([](Footprint f, const glm::dvec2&) {
                 const bool is_x = glm::length(f.per_x) < glm::length(f.per_y);
                 f.per_x = f.per_y = is_x ? f.per_x : f.per_y;
                 return f;
             })},
            {"area_for_the_longer_step", "the LOD is that of the footprint's area", "trilinear-gl",
             by("trilinear-area")},
            {"last_level_missing", "the chain ends at 2 x 2 texels", "trilinear-gl",
             set([](FilterOptions& o) { o.lod_max = 6; })},
            {"trilinear_without_blend", "the level is not blended with the coarser one", "trilinear-gl",
             by("mip-nearest-bilinear")},
            {"blend_in_half_of_each_octave", "levels are blended in the middle half of each octave alone",
             "trilinear-gl", by("brilinear")},
            {"blend_in_every_octave", "levels are blended over the whole octave", "brilinear",
             by("trilinear-gl")}};
}

std::vector<FilterFault> faults_of_weights() {
    return {
        {"catmull_rom_for_bilinear", "bicubic where bilinear is promised", "bilinear", by("bicubic")},
        {"b_spline_for_catmull_rom", "the B-spline where Catmull-Rom is promised", "bicubic", by("bspline")},
        {"bilinear_for_smart_bicubic", "level 0 is read bilinearly", "smart-bicubic", by("trilinear-gl")}};
}

std::vector<FilterFault> faults_of_taps() {
    return {{"taps_to_the_letter", "taps stand at i / (N + 1) instead of in the middles of N parts",
             "aniso-midpoint", by("aniso-ext-linear")},
            {"linear_taps", "taps are linear in the texture where the picture's own places are promised",
             "aniso-ext", by("aniso-ext-linear")},
            {"ratio_rounded_up", "the ratio is rounded up in the LOD, too", "aniso-vulkan", by("aniso-ext")},
            {"anisotropy_not_limited", "more taps than the limit allows", "aniso-midpoint",
             set([](FilterOptions& o) { o.max_anisotropy = 64; })},
            {"one_tap", "one tap, wherever it should be several", "aniso-d3d11",
             set([](FilterOptions& o) { o.max_anisotropy = 1; })},
            {"line_of_half_the_length", "probes reach half as far", "aniso-feline",
             set([](FilterOptions& o) { o.max_anisotropy = 8; })},
            {"eight_texels", "up to eight texels where at most four are promised", "cardinality-4",
             by("cardinality-8")},
            {"table_lod_a_sixteenth_less", "LODs are rounded down to those of the table", "cardinality-4",
             set([](FilterOptions& o) { o.lod_bias = -1 / 16.0; })},
            {"one_lookup", "one anisotropic lookup, wherever it should be five", "aniso-elliptical",
             by("aniso-d3d11")},
            {"fewer_supersamples", "3 x 3 samples instead of 4 x 4", "supersample-bilinear",
             set([](FilterOptions& o) { o.subdivisions = 3; })},
            {"fewer_strips", "at most 8 strips instead of 16", "sat-strips",
             set([](FilterOptions& o) { o.max_anisotropy = 8; })}};
}

std::vector<FilterFault> faults_of_tables() {
    return {{"sat_in_float32", "sums are stored as float32", "sat-moment",
             set([](FilterOptions& o) { o.sat_storage = texture::SatStorage::float32; })},
            {"box_for_triangle", "a box of the same variance, where a triangle is promised", "triangle-sat",
             by("sat-moment")},
            {"triangle_for_quadratic", "the sums are added up twice, where three times are promised",
             "quadratic-sat", by("triangle-sat")},
            {"sat_quad_for_affine", "the box of the true quadrilateral, where the affine one is promised",
             "sat-affine", by("sat-quad")}};
}

std::vector<FilterFault> faults_of_draws() {
    return {{"filtered_instead_of_drawn", "the four texels' mean instead of one that is drawn",
             "stochastic-bilinear", by("bilinear")},
            {"nearest_instead_of_drawn", "the nearest texel instead of one that is drawn",
             "stochastic-bilinear", by("nearest")},
            {"one_number_for_all_samples",
             "all samples of a pixel have the same number",
             "stochastic-bilinear",
             set([](FilterOptions& o) { o.samples = 1; }),
             {.samples = 4}},
            {"white_noise_for_interleaved", "every decision has a number of its own, white noise",
             "stochastic-interleaved", by("stochastic-trilinear")},
            {"interleaved_for_blue", "interleaved gradient noise instead of blue noise", "stochastic-blue",
             by("stochastic-interleaved")},
            {"one_frame_late",
             "the frames of the accumulation begin with the second",
             "stochastic-interleaved",
             set([](FilterOptions& o) { o.seed += 1; }),
             {.samples = 4}},
            {"drawn_lod_half_too_large", "every LOD is a half too large", "stochastic-trilinear",
             set([](FilterOptions& o) { o.lod_bias = 0.5; })}};
}

std::vector<FilterFault> faults_of_textures() {
    return {{"last_column_dropped",
             "the last column and row of odd sizes have no part in coarser levels",
             "trilinear-gl",
             set([](FilterOptions& o) { o.mip_kernel = texture::MipKernel::box; }),
             {},
             Ground::odd_sizes},
            {"lanczos_for_box", "levels are made by Lanczos instead of the box", "trilinear-gl",
             set([](FilterOptions& o) { o.mip_kernel = texture::MipKernel::lanczos3; })},
            {"lanczos_for_kaiser",
             "levels are made by Lanczos instead of Kaiser",
             "trilinear-gl",
             set([](FilterOptions& o) { o.mip_kernel = texture::MipKernel::lanczos3; }),
             {.mip_kernel = texture::MipKernel::kaiser3}},
            {"codes_filtered", "sRGB codes are filtered and decoded then", "trilinear-gl",
             set([](FilterOptions& o) { o.decoding = texture::Decoding::after_filtering; })},
            {"light_filtered",
             "light is filtered where codes are promised",
             "trilinear-gl",
             set([](FilterOptions& o) { o.decoding = texture::Decoding::before_filtering; }),
             {.decoding = texture::Decoding::after_filtering}},
            {"texels_weighed_alike", "every texel counts alike, whatever it covers of the surface",
             "trilinear-parameterization-aware", by("trilinear-gl")},
            {"first_triangle_alone", "texels are weighed by the first triangle alone",
             "trilinear-parameterization-aware",
             showing([](std::vector<texture::SurfaceTriangle>& all) { all.resize(1); })},
            {"factor_ignored", "the material's factor is ignored", "bilinear",
             of([](Scene& s) { s.materials[0].base_color_factor = glm::vec4{1}; })},
            {"picture_of_8_bits", "the picture holds multiples of 1/255", "trilinear-gl",
             afterwards([](const LinearRgb& c) {
                 const auto coded = [](float x) { return std::round(x * 255) / 255; };
                 return LinearRgb{coded(c.r), coded(c.g), coded(c.b)};
             })}};
}

}  // namespace

std::vector<FilterFault> filter_faults() {
    std::vector<FilterFault> all;
    for (const auto& some : {faults_of_places, faults_of_steps, faults_of_levels, faults_of_weights,
                             faults_of_taps, faults_of_tables, faults_of_draws, faults_of_textures})
        for (FilterFault& fault : some()) all.push_back(std::move(fault));
    return all;
}

}  // namespace zproof::selftest
