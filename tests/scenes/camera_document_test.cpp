// The matrices of a camera file against the camera's own definition (scenes/camera.h).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenes/view_document.h"

namespace zproof {
namespace {

using Vector = std::array<double, 4>;
using Rows = std::vector<std::vector<double>>;

double row_times(const std::vector<double>& row, const Vector& p) {
    return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3] * p[3];
}

/// Where the file's matrices put a point, and the depth that they keep.
struct Image {
    double x_raster, y_raster, z_ndc, depth;
};

Image image_of(const nlohmann::json& file, const glm::dvec3& p_world) {
    const Rows camera = file.at("camera_from_world"), clip = file.at("clip_from_camera"),
               raster = file.at("raster_from_ndc");
    const Vector world{p_world.x, p_world.y, p_world.z, 1};
    Vector p_camera{}, p_clip{};
    for (std::size_t i = 0; i < 4; ++i) p_camera[i] = row_times(camera[i], world);
    for (std::size_t i = 0; i < 4; ++i) p_clip[i] = row_times(clip[i], p_camera);
    const Vector ndc{p_clip[0] / p_clip[3], p_clip[1] / p_clip[3], p_clip[2] / p_clip[3], 1};
    return {row_times(raster[0], ndc), row_times(raster[1], ndc), ndc[2], -p_camera[2]};
}

View some_view(Projection projection, NdcDepth ndc_depth, double far) {
    View view{.name = "v", .camera = look_at({3, 2, 5}, {0, 1, -1}, {0, 1, 0}), .width = 640, .height = 400};
    view.camera.projection = projection;
    view.camera.window = {.left = -0.3, .right = 0.9, .bottom = -0.5, .top = 0.25};
    if (projection == Projection::parallel) view.camera.shear = {0.25, -0.125};
    view.camera.near_depth = 0.5;
    view.camera.far_depth = far;
    view.camera.ndc_depth = ndc_depth;
    return view;
}

/// The point at camera depth t on the view ray through raster position (x, y), from camera.h's formulas.
glm::dvec3 point_at(const View& view, double x, double y, double t) {
    const Camera& c = view.camera;
    const double u = c.window.left + (c.window.right - c.window.left) * x / view.width;
    const double v = c.window.top - (c.window.top - c.window.bottom) * y / view.height;
    const glm::dvec3 p_camera = c.projection == Projection::perspective
                                    ? t * glm::dvec3{u, v, -1}
                                    : glm::dvec3{u, v, 0} + t * glm::dvec3{c.shear.x, c.shear.y, -1};
    return glm::dvec3{c.eye_world} + p_camera.x * c.right + p_camera.y * c.up + p_camera.z * c.back;
}

struct Ends {
    double near_z, far_z;
};

Ends ends_of(NdcDepth depth) {
    if (depth == NdcDepth::minus_one_to_one) return {-1, 1};
    return depth == NdcDepth::zero_to_one ? Ends{0, 1} : Ends{1, 0};
}

TEST(CameraDocument, ItsMatricesAreTheCamera) {
    for (const Projection projection : {Projection::perspective, Projection::parallel})
        for (const NdcDepth ndc :
             {NdcDepth::minus_one_to_one, NdcDepth::zero_to_one, NdcDepth::zero_to_one_reversed}) {
            const View view = some_view(projection, ndc, 20);
            const auto file = nlohmann::json::parse(camera_document(view));
            for (const double depth : {0.5, 3.0, 20.0}) {
                const Image image = image_of(file, point_at(view, 123.25, 77.5, depth));
                EXPECT_NEAR(image.x_raster, 123.25, 1e-9);
                EXPECT_NEAR(image.y_raster, 77.5, 1e-9);
                EXPECT_NEAR(image.depth, depth, 1e-12);
            }
            EXPECT_NEAR(image_of(file, point_at(view, 9, 9, 0.5)).z_ndc, ends_of(ndc).near_z, 1e-12);
            EXPECT_NEAR(image_of(file, point_at(view, 9, 9, 20)).z_ndc, ends_of(ndc).far_z, 1e-12);
        }
}

TEST(CameraDocument, AnEndlessFarPlaneIsTheLimit) {
    for (const NdcDepth ndc :
         {NdcDepth::minus_one_to_one, NdcDepth::zero_to_one, NdcDepth::zero_to_one_reversed}) {
        const View view = some_view(Projection::perspective, ndc, std::numeric_limits<double>::infinity());
        const auto file = nlohmann::json::parse(camera_document(view));
        EXPECT_EQ(file.at("far"), "infinity");
        EXPECT_NEAR(image_of(file, point_at(view, 9, 9, 0.5)).z_ndc, ends_of(ndc).near_z, 1e-12);
        EXPECT_NEAR(image_of(file, point_at(view, 9, 9, 1e15)).z_ndc, ends_of(ndc).far_z, 1e-12);
    }
}

}  // namespace
}  // namespace zproof
