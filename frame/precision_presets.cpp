#include "frame/precision_presets.h"

#include <algorithm>
#include <array>

namespace zproof {

namespace {

/// z from 0 at near to 1 at far, by a plane equation after clipping.
constexpr RasterPrecision graphics_api{.clipping = Clipping::view_volume,
                                       .depth_buffer = DepthBuffer::standard_z,
                                       .matrix_far = MatrixFar::finite,
                                       .depth_interpolation = DepthInterpolation::plane};

constexpr RasterPrecision opengl() {
    RasterPrecision p = graphics_api;
    p.clip_range = ClipRange::minus_one_to_one;
    return p;
}

constexpr RasterPrecision opengl_24bit() {
    RasterPrecision p = opengl();
    p.depth_format = DepthFormat::unorm24;
    return p;
}

constexpr RasterPrecision d3d11() {
    RasterPrecision p = graphics_api;
    p.clipping = Clipping::guard_band;
    p.depth_format = DepthFormat::unorm24;
    return p;
}

/// Two matrices, and the frame shows a varying.
constexpr RasterPrecision webgl() {
    RasterPrecision p = opengl_24bit();
    p.matrices = 2;
    p.depth_roundings = 4;
    p.shown_depth = ShownDepth::varying;
    return p;
}

/// Its areas are of normalized device coordinates; in pixels they grow with the picture, here up to 4096.
constexpr RasterPrecision pytorch3d() {
    constexpr double least_area_px2 = 0.5e-8 * 2048 * 2048;
    return {.matrices = 2,
            .snap = Snap::none,
            .edge_functions = EdgeFunctions::from_corner,
            .least_area_px2 = least_area_px2,
            .area_epsilon_px2 = least_area_px2,
            .watertight = false,
            .depth_roundings = 16};
}

const std::array known_precisions{
    PrecisionPreset{"opengl", opengl(),
                    "OpenGL 4.6 core, 13.7 (clipping), 13.8 (viewport), 14.6.1 (polygons)"},
    PrecisionPreset{"opengl-24bit", opengl_24bit(), "the same, with GL_DEPTH_COMPONENT24 (2.3.5)"},
    PrecisionPreset{"d3d11", d3d11(),
                    "Direct3D 11.3, 3.4.1 (8 sub-pixel bits), 15.16 (guard band), D24_UNORM"},
    PrecisionPreset{"vulkan", graphics_api,
                    "Vulkan 1.3, 27.3 (clip volume), subPixelPrecisionBits = 8, D32_SFLOAT"},
    PrecisionPreset{"webgl", webgl(), "WebGL 1.0, 2.2 (depth of the drawing buffer); three.js: two matrices"},
    PrecisionPreset{"vtk", opengl_24bit(), "VTK's vtkOpenGLRenderWindow: 24 bits of depth, one matrix"},
    PrecisionPreset{"pytorch3d", pytorch3d(), "PyTorch3D's rasterize_meshes: float32, kEpsilon = 1e-8"},
    PrecisionPreset{
        "cycles",
        RayPrecision{.aim_offset_px = 0.005, .direction_roundings = 16, .hit_point = HitPoint::barycentrics},
        "Blender's Cycles: Pluecker test, hit from barycentrics, filter of 0.01 px"},
    PrecisionPreset{"embree", RayPrecision{}, "Embree 3.13 and 4, RTC_SCENE_FLAG_ROBUST"},
    PrecisionPreset{"open3d", RayPrecision{.direction_roundings = 8},
                    "Open3D's RaycastingScene: Embree, rays of a pinhole camera in float32"},
    PrecisionPreset{"moeller-trumbore-float32",
                    RayPrecision{.test = RayTest::moeller_trumbore, .watertight = false},
                    "Moeller and Trumbore 1997, in float32"},
};

}  // namespace

std::span<const PrecisionPreset> precision_presets() { return known_precisions; }

std::optional<Precision> preset_precision(std::string_view name) {
    const auto found = std::ranges::find(known_precisions, name, &PrecisionPreset::name);
    return found == known_precisions.end() ? std::nullopt : std::optional(found->precision);
}

}  // namespace zproof
