/// Depths in other units, of other places, or of too few bits.
#include <cmath>

#include "tests/reports_from_the_field/field_frames.h"
#include "tests/reports_from_the_field/field_scenes.h"
#include "tests/reports_from_the_field/ray_caster.h"

namespace zproof::field_reports {

namespace {

/// What is known of a pixel that shows a triangle.
struct Seen {
    const View& view;
    const Frame& good;
    int x, y;
    double depth, ray_length;  ///< the ray's, per unit of depth
};

double ray_length(const View& view, int x, int y) {
    const Camera& c = view.camera;
    if (c.projection == Projection::parallel) return 1;
    const double u = c.window.left + (c.window.right - c.window.left) * (x + 0.5) / view.width;
    const double v = c.window.top - (c.window.top - c.window.bottom) * (y + 0.5) / view.height;
    return std::sqrt(u * u + v * v + 1);
}

std::function<Shown()> telling(const Scene& scene, const View& view,
                               const std::function<double(const Seen&)>& told) {
    return [=] {
        const Frame good = cast(scene, view);
        Frame frame = good;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const double depth = double(good.camera_depth.at(x, y));
                if (good.primitive.at(x, y) == PrimitiveId::none) continue;
                frame.camera_depth.at(x, y) = float(told({view, good, x, y, depth, ray_length(view, x, y)}));
            }
        return Shown{scene, view, frame};
    };
}

/// The mean over 3 x 3 pixels; background is left out.
double averaged(const Seen& s) {
    double sum = 0, count = 0;
    for (int y = std::max(0, s.y - 1); y <= std::min(s.view.height - 1, s.y + 1); ++y)
        for (int x = std::max(0, s.x - 1); x <= std::min(s.view.width - 1, s.x + 1); ++x) {
            const float depth = s.good.camera_depth.at(x, y);
            if (depth == background_depth) continue;
            sum += double(depth);
            ++count;
        }
    return sum / count;
}

/// z of a standard z buffer, and back with other planes.
double read_with(double depth, double near, double far, double read_near, double read_far) {
    const double z = far * (depth - near) / (depth * (far - near));
    return read_near * read_far / (read_far - z * (read_far - read_near));
}

/// A number in bytes of one base that were read to another; a byte counts as 1/255 of the first.
double packed(double number, int written, int read) {
    double sum = 0, weight = 1;
    for (int k = 0; k < 4; ++k, weight /= read) {
        const double byte = std::floor(number * written);
        number = number * written - byte;
        sum += byte / 255 * weight;
    }
    return sum;
}

/// z in [0, 1] of a standard z buffer.
double z_of(const Seen& s) {
    const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
    return far * (s.depth - near) / (s.depth * (far - near));
}

double back_from_z(const Seen& s, double z) {
    const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
    return near * far / (far - z * (far - near));
}

/// In whole steps of a buffer that holds depth itself.
double of_linear_bits(const Seen& s, int bits) {
    const double near = s.view.camera.near_depth, range = s.view.camera.far_depth - near;
    const double most = std::ldexp(1.0, bits) - 1;
    return near + std::round((s.depth - near) / range * most) / most * range;
}

double of_z_bits(const Seen& s, int bits) {
    const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
    const double most = std::ldexp(1.0, bits) - 1;
    const double z = std::round(far * (s.depth - near) / (s.depth * (far - near)) * most) / most;
    return near * far / (far - z * (far - near));
}

View tight_view() {
    View view = view_of_yard();
    view.camera.near_depth = 2;
    view.camera.far_depth = 12;
    return view;
}

View endless_view() {
    View view = view_of_yard();
    view.camera.far_depth = HUGE_VAL;
    return view;
}

/// So near that some of it lies nearer than 1.
View view_near_the_yard() {
    View view = view_of_yard();
    const Camera near = look_at({-1.5, 0.6, 1.2}, {-1.2, 0.1, -1}, {0, 1, 0});
    view.camera.eye_world = near.eye_world;
    view.camera.right = near.right;
    view.camera.up = near.up;
    view.camera.back = near.back;
    return view;
}

std::function<Shown()> with_rows_from_below(const std::function<Shown()>& upright) {
    return [=] {
        Shown shown = upright();
        const Frame frame = shown.frame;
        for (int y = 0; y < shown.view.height; ++y)
            for (int x = 0; x < shown.view.width; ++x) {
                const int from = shown.view.height - 1 - y;
                shown.frame.primitive.at(x, y) = frame.primitive.at(x, from);
                shown.frame.camera_depth.at(x, y) = frame.camera_depth.at(x, from);
            }
        return shown;
    };
}

/// Depth where the ray of another place meets the plane of the pixel's triangle.
double on_plane_at(const Scene& scene, const Seen& s, double x, double y) {
    const Camera& c = s.view.camera;
    const glm::uvec3 t = scene.triangles[std::size_t(s.good.primitive.at(s.x, s.y))];
    const auto p = [&](int k) {
        const glm::dvec3 v = glm::dvec3(scene.vertices.position_world[t[k]]) - glm::dvec3(c.eye_world);
        return glm::dvec3(dot(c.right, v), dot(c.up, v), -dot(c.back, v));
    };
    const double u = c.window.left + (c.window.right - c.window.left) * x / s.view.width;
    const double v = c.window.top - (c.window.top - c.window.bottom) * y / s.view.height;
    const glm::dvec3 normal = cross(p(1) - p(0), p(2) - p(0));
    return dot(p(0), normal) / dot(glm::dvec3(u, v, 1), normal);
}

}  // namespace

std::vector<FieldFrame> frames_of_depth() {
    const Scene square = square_ahead(2, 1.5f), ground = yard();
    const View ahead = view_ahead(60, 64, 64, 0.01, 100), view = view_of_yard();
    const View parallel = parallel_view_ahead(0.5, 0.5, 64, 64, 0.05, 100);
    const RayPrecision ray{.arithmetic = Arithmetic::float32};
    const auto as_perspective = [](const Seen& s) {
        const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
        const double z = (s.depth - near) / (far - near);
        return near * far / (far - z * (far - near));
    };
    return {
        {"from_the_near_plane_along_the_ray",
         {"depth is the ray's length from the near plane"},
         "mitsuba3 #491: a square at 1 m is 0.99 m away, near is 10 mm",
         telling(square, ahead,
                 [](const Seen& s) { return (s.depth - s.view.camera.near_depth) * s.ray_length; })},
        {"ray_length",
         {"depth is the ray's length"},
         "camtools #11: distance of a unit ray taken for depth",
         telling(ground, view, [](const Seen& s) { return s.depth * s.ray_length; })},
        {"ray_length_less_near",
         {"depth is the ray's length less near"},
         "zproof #43: near is subtracted from the distance",
         telling(ground, view, [](const Seen& s) { return s.depth * s.ray_length - 0.1; })},
        {"ray_length_of_a_caster",
         {"depth is the ray's length"},
         "camtools #11, of a renderer that declares rays",
         telling(ground, view, [](const Seen& s) { return s.depth * s.ray_length; }),
         ray},
        {"ndc",
         {"depth is NDC z (-1 to 1)"},
         "nvdiffrast #133: the third component is z/w",
         telling(ground, view, [](const Seen& s) { return 2 * z_of(s) - 1; })},
        {"ndc_from_0",
         {"depth is NDC z (0 to 1)"},
         "bullet3 PR #1439: the depth buffer's value",
         telling(ground, view, z_of)},
        {"ndc_reversed",
         {"depth is NDC z (1 to 0, reversed)"},
         "zproof #43: the value of a reversed depth buffer",
         telling(ground, view, [](const Seen& s) { return 1 - z_of(s); })},
        {"reciprocal",
         {"depth is 1/depth"},
         "zproof #43: disparity for depth",
         telling(ground, view, [](const Seen& s) { return 1 / s.depth; })},
        {"normalized",
         {"depth is scaled to 0 at near and 1 at far"},
         "Babylon.js PR #394: depth between 0 and 1",
         telling(ground, view,
                 [](const Seen& s) {
                     const Camera& c = s.view.camera;
                     return (s.depth - c.near_depth) / (c.far_depth - c.near_depth);
                 })},
        {"millimetres",
         {"depth is in other units"},
         "zproof #43: millimetres for metres",
         telling(ground, view, [](const Seen& s) { return 1000 * s.depth; })},
        {"z_in_camera_space",
         {"depth has the wrong sign"},
         "zproof #43: z in camera space, negative ahead",
         telling(ground, view, [](const Seen& s) { return -s.depth; })},
        {"from_the_near_plane",
         {"depth is counted from the near plane"},
         "three.js #9009: a ray of an orthographic camera starts on the near plane",
         telling(ground, parallel_view_of_yard(2, 1.5, 64, 48),
                 [](const Seen& s) { return s.depth - s.view.camera.near_depth; })},
        {"orthographic_as_perspective",
         {"depth is of a parallel view, read as a perspective's"},
         "pyrender #19, #72, #254: 2.7464 is told as 0.0513856, near 0.05, far 100",
         telling(square_ahead(2.7464f, 0.4f), parallel, as_perspective)},
        {"orthographic_yard_as_perspective",
         {"depth is of a parallel view, read as a perspective's"},
         "Open3D #2315, mujoco PR #3523: the same",
         telling(ground, parallel_view_of_yard(2, 1.5, 64, 48), as_perspective)},
        {"perspective_as_orthographic",
         {"depth is of a perspective, read as a parallel view's"},
         "zproof #43: the other way round",
         telling(ground, view,
                 [](const Seen& s) {
                     const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
                     return near + far * (s.depth - near) / s.depth;
                 })},
        {"averaged",
         {"depth is averaged over 3 x 3 pixels"},
         "mitsuba3 #396, LuxCore #361, mitsuba #29: depths between near and far at silhouettes",
         telling(ground, view, averaged)},
        {"depth_of_8_bits",
         {"depth has 8 bits, fixed point"},
         "zproof #43: z buffer of 8 bits",
         telling(ground, tight_view(), [](const Seen& s) { return of_z_bits(s, 8); })},
        {"depth_of_8_bits_linear",
         {"depth has 8 bits, in equal steps"},
         "zproof #43: depth as a grey value",
         telling(ground, tight_view(), [](const Seen& s) { return of_linear_bits(s, 8); })},
        {"depth_of_16_bits",
         {"depth has 16 bits, fixed point"},
         "zproof #43: z buffer of 16 bits",
         telling(ground, view, [](const Seen& s) { return of_z_bits(s, 16); })},
        {"depth_of_16_bits_linear",
         {"depth has 16 bits, in equal steps"},
         "zproof #43: depth as a grey value of 16 bits",
         telling(ground, view, [](const Seen& s) { return of_linear_bits(s, 16); })},
        {"half_float",
         {"depth is a float of 11 bits"},
         "zproof #43: depth as a half float",
         telling(ground, view,
                 [](const Seen& s) {
                     const double step = std::ldexp(1.0, std::ilogb(s.depth) - 10);
                     return std::nearbyint(s.depth / step) * step;
                 })},
        {"averaged_of_a_caster",
         {"depth is averaged over 3 x 3 pixels"},
         "mitsuba3 #396, of a renderer that declares rays",
         telling(ground, view, averaged),
         ray},
        {"biased_in_parallel",
         {"depth is biased by a constant"},
         "zproof #43: a constant is added, in an orthographic view",
         telling(ground, parallel_view_of_yard(2, 1.5, 64, 48),
                 [](const Seen& s) { return s.depth - 0.0321; })},
        {"biased_of_a_caster",
         {"depth is biased by a constant"},
         "zproof #43: a constant is added, of a renderer that declares rays",
         telling(ground, view, [](const Seen& s) { return s.depth - 0.001; }),
         ray},
        {"biased",
         {"depth is biased by a constant"},
         "zproof #43: a constant is added",
         telling(ground, view, [](const Seen& s) { return s.depth + 0.0123; })},
        {"scaled",
         {"depth is scaled by a constant"},
         "three.js PR #32805, filament PR #2735: a camera whose node's scale is kept",
         telling(ground, view, [](const Seen& s) { return s.depth / 0.37; })},
        {"another_far",
         {"depth is read with another far plane"},
         "zproof #43: the far plane of the projection is another's",
         telling(ground, view, [](const Seen& s) { return read_with(s.depth, 0.1, 60, 0.1, 100); })},
        {"another_near",
         {"depth is read with another near plane"},
         "zproof #43: the near plane of the projection is another's",
         telling(ground, view, [](const Seen& s) { return read_with(s.depth, 0.1, 60, 0.05, 60); })},
        {"far_less_near",
         {"depth is scaled by a constant"},
         "ai2thor #1301: Linear01Depth times (far - near) instead of far",
         telling(ground, tight_view(), [](const Seen& s) { return s.depth / 12 * 10; })},
        {"first_pixel_of_the_quad",
         {"depth is that of the first of 2 x 2 pixels"},
         "zproof #43: depth of the quad's first pixel",
         telling(ground, view,
                 [](const Seen& s) { return double(s.good.camera_depth.at(s.x & ~1, s.y & ~1)); })},
        {"corner_of_the_pixel",
         {"depth is taken (-1/2, -1/2) px beside the centre"},
         "zproof #43: depth of another place than the id's",
         telling(ground, view, [=](const Seen& s) { return on_plane_at(ground, s, s.x, s.y); })},
        {"side_of_the_pixel_of_a_caster",
         {"depth is taken (+1/2, 0) px beside the centre"},
         "zproof #43: depth of another place than the id's, of a renderer that declares rays",
         telling(ground, view, [=](const Seen& s) { return on_plane_at(ground, s, s.x + 1, s.y + 0.5); }),
         ray},
        {"nearer_far_plane",
         {"the far plane lies nearer"},
         "zproof #43: far at another place",
         [=] {
             View clipped = view;
             clipped.camera.far_depth = 5.5;
             return Shown{ground, view, cast(ground, clipped)};
         }},
        {"farther_near_plane",
         {"the near plane lies farther"},
         "zproof #43: near at another place",
         [=] {
             View clipped = view;
             clipped.camera.near_depth = 4.1;
             return Shown{ground, view, cast(ground, clipped)};
         }},
    };
}

std::vector<FieldFrame> frames_of_depth_pictures() {
    const Scene ground = yard();
    const View view = view_of_yard(), tight = tight_view();
    const auto share = [](const Seen& s) {
        const Camera& c = s.view.camera;
        return (s.depth - c.near_depth) / (c.far_depth - c.near_depth);
    };
    const auto height = [](const Seen& s) {
        const Camera& c = s.view.camera;
        const double u = c.window.left + (c.window.right - c.window.left) * (s.x + 0.5) / s.view.width;
        const double v = c.window.top - (c.window.top - c.window.bottom) * (s.y + 0.5) / s.view.height;
        return double(c.eye_world.y) + s.depth * (u * c.right.y + v * c.up.y - c.back.y);
    };
    const auto named = [&](const char* name, const char* cause, const char* source, const View& of,
                           const std::function<double(const Seen&)>& told) {
        return FieldFrame{name, {cause}, source, telling(ground, of, told)};
    };
    return {
        {"rows_of_window_z_from_below",
         {"the image is flipped in y, and depth is NDC z (0 to 1)"},
         "glReadPixels of the depth buffer",
         with_rows_from_below(telling(ground, tight, z_of))},
        {"rows_of_ray_lengths_from_below",
         {"the image is flipped in y, and depth is the ray's length"},
         "a ray caster's picture read by OpenGL",
         with_rows_from_below(telling(ground, view, [](const Seen& s) { return s.depth * s.ray_length; }))},
        named("gamma_of_metres", "depth went through a curve of gamma 2.2",
              "a float picture encoded for display", view,
              [](const Seen& s) { return std::pow(s.depth, 1 / 2.2); }),
        named("gamma_of_metres_undone", "depth went through a curve of gamma 1/2.2",
              "a float picture taken for a display's", view,
              [](const Seen& s) { return std::pow(s.depth, 2.2); }),
        named("gamma_of_grey", "depth from near to far went through a curve of gamma 2.2",
              "depth as a grey value, encoded for display", tight,
              [=](const Seen& s) { return std::pow(share(s), 1 / 2.2); }),
        named("gamma_of_grey_undone", "depth from near to far went through a curve of gamma 1/2.2",
              "depth as a grey value, taken for a display's", tight,
              [=](const Seen& s) { return std::pow(share(s), 2.2); }),
        named("srgb_of_grey", "depth from near to far went through the curve of sRGB",
              "depth as a grey value in a texture of sRGB", tight,
              [=](const Seen& s) {
                  const double c = share(s);
                  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
              }),
        named("logarithm", "depth is a logarithm", "log(z)", view,
              [](const Seen& s) { return std::log(s.depth); }),
        named("logarithmic_buffer", "depth from near to far is a logarithm", "a logarithmic depth buffer",
              tight, [](const Seen& s) { return std::log(s.depth / 2) / std::log(12.0 / 2); }),
        named("disparity", "depth is a disparity", "focal length 57.3 px, baseline 0.1", view,
              [](const Seen& s) { return 5.73 / s.depth; }),
        named("clamped_at_1", "depth is clamped at 1", "a depth in metres in a picture of 0 to 1",
              view_near_the_yard(), [](const Seen& s) { return std::min(1.0, s.depth); }),
        named("height", "depth is the point's y in the world", "a position's channel taken for depth", view,
              height),
        named("whole_millimetres", "depth is in whole steps of 0.001", "BOP: 16-bit depth in millimetres",
              view, [](const Seen& s) { return std::round(s.depth * 1000) / 1000; }),
        named("cut_to_millimetres", "depth is cut to whole steps of 0.001", "(uint16) (1000 * z)", view,
              [](const Seen& s) { return std::floor(s.depth * 1000) / 1000; }),
        named("raised_to_centimetres", "depth is raised to whole steps of 0.01", "ceil(100 * z)", view,
              [](const Seen& s) { return std::ceil(s.depth * 100) / 100; }),
        named("packed_by_255_read_by_256", "depth is packed in bytes with 256 for 255",
              "three.js's packDepthToRGBA before r99 and after", view,
              [=](const Seen& s) { return 0.1 + 59.9 * packed(share(s), 255, 256); }),
        named("z_packed_by_255_read_by_256", "depth is packed in bytes with 256 for 255",
              "a shadow map's packing of window z", tight,
              [](const Seen& s) { return back_from_z(s, packed(z_of(s), 255, 256)); }),
        named("packed_by_256_read_by_255", "depth is packed in bytes with 255 for 256",
              "CARLA: R + 256 G + 65536 B, of 1000 m", view,
              [=](const Seen& s) { return 60 * packed(s.depth / 60, 256, 255); }),
        named("bytes_of_256_for_255", "depth is packed in bytes with 255 for 256",
              "a byte counts as 1/255 where it is 1/256", tight,
              [](const Seen& s) { return back_from_z(s, packed(z_of(s), 256, 256)); }),
        named("whole_centimetres", "depth is in whole steps of 0.01", "depth in centimetres", view,
              [](const Seen& s) { return std::round(s.depth * 100) / 100; }),
        named("ndc_without_2z_minus_1", "z from 0 to 1 is turned back as if it were NDC z",
              "LearnOpenGL's formula, given gl_FragCoord.z", tight,
              [](const Seen& s) {
                  const double near = s.view.camera.near_depth, far = s.view.camera.far_depth;
                  return 2 * near * far / (far + near - z_of(s) * (far - near));
              }),
        named("ndc_as_z", "NDC z is turned back as if it were from 0 to 1", "the same, the other way round",
              tight, [](const Seen& s) { return back_from_z(s, 2 * z_of(s) - 1); }),
        named("reversed_z_read_forwards", "z is turned back from its other end",
              "reversed z, and the old formula", tight,
              [](const Seen& s) { return back_from_z(s, 1 - z_of(s)); }),
        named("near_and_far_both_wrong", "depth is read with other planes",
              "the example program's near and far", view,
              [](const Seen& s) { return read_with(s.depth, 0.1, 60, 1, 1000); }),
        named("least_and_greatest_to_0_and_1", "depth is scaled and biased",
              "a picture normalized by its own range", view,
              [](const Seen& s) {
                  double least = HUGE_VAL, greatest = 0;
                  for (const float depth : s.good.camera_depth.pixels())
                      if (depth != background_depth)
                          least = std::min(least, double(depth)),
                          greatest = std::max(greatest, double(depth));
                  return (s.depth - least) / (greatest - least);
              }),
        named("near_is_white", "depth is scaled and biased", "an inverted grey value", tight,
              [=](const Seen& s) { return 1 - share(s); }),
        named("grey_of_256_levels", "depth is scaled and biased", "the same in 8 bits", tight,
              [=](const Seen& s) { return std::round(255 * (1 - share(s))); }),
        named("gamma_of_depth_by_far", "depth by far went through a curve of gamma 2.2",
              "z / far, for display", view, [](const Seen& s) { return std::pow(s.depth / 60, 1 / 2.2); }),
        named("logarithm_of_1_more", "depth is a logarithm, counted from 1",
              "three.js: log2(1 + w) / log2(1 + far) in gl_FragDepth", view,
              [](const Seen& s) { return std::log2(1 + s.depth) / std::log2(61.0); }),
        named("range_of_a_sensor", "depths beyond a limit are told as the limit", "a depth camera's range",
              view, [](const Seen& s) { return std::min(s.depth, 5.0); }),
        named("out_of_range", "depths beyond a limit are told as 0", "a depth camera that sees nothing there",
              view, [](const Seen& s) { return s.depth > 5 ? 0 : s.depth; }),
        named("millimetres_of_16_bits", "depth is in other units",
              "depth in a PNG of 16 bits, not scaled back", view,
              [](const Seen& s) { return std::round(s.depth * 1000); }),
        named("millimetres_of_an_endless_view", "depth is in other units", "glTF's camera without zfar",
              endless_view(), [](const Seen& s) { return std::round(s.depth * 1000); }),
        named("disparity_of_16_levels", "depth is a disparity", "OpenCV's StereoSGBM: 16 levels a pixel",
              view, [](const Seen& s) { return std::round(16 * 573 / s.depth) / 16; }),
        named("bfloat16", "depth is a float of 8 bits", "autocast of a neural renderer", view,
              [](const Seen& s) {
                  const int exponent = std::ilogb(s.depth);
                  return std::ldexp(std::round(std::ldexp(s.depth, 7 - exponent)), exponent - 7);
              }),
    };
}

}  // namespace zproof::field_reports
