#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <numbers>

#include "scenes/camera.h"
#include "scenes/camera_matrices.h"
#include "scenes/judged_ranges.h"
#include "zproof/data.h"
#include "zproof/errors.h"
#include "zproof/names.h"

namespace zproof::api {
namespace {

/// A rotation in float32 is one to within a few units of 2^-24.
constexpr double rotation_tolerance = 1e-5;

glm::dvec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

View view_of(const Camera& camera, Size size, const std::string& name) {
    const zproof::View view{
        .name = name, .camera = camera, .width = size.width, .height = size.height, .sample = {}};
    validate(camera);
    require_judged(view);
    return View{std::make_shared<View::Data>(View::Data{view})};
}

Camera placed_camera(const View::Placed& placed) {
    require_name("view", placed.name);
    require_size("view", placed.size);
    Camera camera = look_at(vector_of(placed.eye), vector_of(placed.target), vector_of(placed.up));
    camera.near_depth = placed.near_depth;
    camera.far_depth = placed.far_depth;
    return camera;
}

double aspect_of(Size size) { return double(size.width) / double(size.height); }

/// By Newton's iteration for the orthogonal part of the polar decomposition (Higham 1986).
glm::dmat3 nearest_rotation(glm::dmat3 m) {
    constexpr int enough = 6;  // it converges quadratically, from 1e-5
    for (int i = 0; i < enough; ++i) m = 0.5 * (m + glm::inverse(glm::transpose(m)));
    return m;
}

glm::dmat3 rotation_of(const std::array<double, 9>& R) {
    const glm::dmat3 m{R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]};
    const glm::dmat3 error = m * glm::transpose(m) - glm::dmat3(1.0);
    double largest = 0;
    for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(error[i / 3][i % 3]));
    if (!(largest <= rotation_tolerance) || !(glm::determinant(m) > 0))
        throw InputError{"from_opencv: R is no rotation; expected R R^T = 1 to within 1e-5 and det R = 1"};
    return nearest_rotation(m);
}

struct Intrinsics {
    double fx, fy, cx, cy;
};

Intrinsics intrinsics_of(const std::array<double, 9>& K) {
    const bool is_usable = K[0] > 0 && K[4] > 0 && K[1] == 0 && K[3] == 0 && K[6] == 0 && K[7] == 0 &&
                           K[8] == 1 && std::isfinite(K[0] + K[2] + K[4] + K[5]);
    if (!is_usable)
        throw InputError{
            "from_opencv: K is not usable; expected [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] with fx, fy > 0 "
            "and "
            "no skew"};
    return {K[0], K[4], K[2], K[5]};
}

/// Pixel (0, 0) has its centre at (0, 0), so that the image begins half a pixel before.
Window window_of(const Intrinsics& k, Size size) {
    return {.left = (-0.5 - k.cx) / k.fx,
            .right = (size.width - 0.5 - k.cx) / k.fx,
            .bottom = -(size.height - 0.5 - k.cy) / k.fy,
            .top = (0.5 + k.cy) / k.fy};
}

}  // namespace

View View::perspective(const Placed& placed, double yfov) {
    return told_as_input_error([&] {
        if (!(yfov > 0 && yfov < std::numbers::pi))
            throw InputError{"perspective: yfov is " + std::to_string(yfov) +
                             "; expected radians between 0 and pi"};
        Camera camera = placed_camera(placed);
        camera.window = symmetric_window(yfov, aspect_of(placed.size));
        return view_of(camera, placed.size, placed.name);
    });
}

View View::orthographic(const Placed& placed, double height) {
    return told_as_input_error([&] {
        Camera camera = placed_camera(placed);
        const double up = height / 2, right = up * aspect_of(placed.size);
        camera.projection = Projection::parallel;
        camera.window = {-right, right, -up, up};
        return view_of(camera, placed.size, placed.name);
    });
}

View View::from_opencv(const OpenCv& camera, Size size, double near_depth, double far_depth,
                       std::string name) {
    return told_as_input_error([&] {
        require_name("view", name);
        require_size("view", size);
        const glm::dmat3 R = rotation_of(camera.R);
        Camera c;
        c.window = window_of(intrinsics_of(camera.K), size);
        c.eye_world = glm::vec3(-(glm::transpose(R) * vector_of(camera.t)));
        c.right = glm::row(R, 0);
        c.up = -glm::row(R, 1);
        c.back = -glm::row(R, 2);
        c.near_depth = near_depth;
        c.far_depth = far_depth;
        return view_of(c, size, name);
    });
}

const std::string& View::name() const { return data().view.name; }
Size View::size() const { return {data().view.width, data().view.height}; }
double View::near_depth() const { return data().view.camera.near_depth; }
double View::far_depth() const { return data().view.camera.far_depth; }
bool View::is_perspective() const { return data().view.camera.projection == Projection::perspective; }

View::OpenCv View::opencv() const {
    if (!is_perspective()) throw InputError{"opencv: a parallel projection has no matrix K"};
    const Camera& c = data().view.camera;
    const auto [width, height] = size();
    const double fx = width / (c.window.right - c.window.left),
                 fy = height / (c.window.top - c.window.bottom);
    const glm::dvec3 x = c.right, y = -c.up, z = -c.back, eye{c.eye_world};
    return {.K = {fx, 0, -fx * c.window.left - 0.5, 0, fy, fy * c.window.top - 0.5, 0, 0, 1},
            .R = {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z},
            .t = {-glm::dot(x, eye), -glm::dot(y, eye), -glm::dot(z, eye)}};
}

View::Matrices View::matrices() const {
    Camera camera = data().view.camera;
    camera.ndc_depth = NdcDepth::minus_one_to_one;
    const auto flat = [](const MatrixRows& rows) {
        std::array<double, 16> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = rows[i / 4][i % 4];
        return all;
    };
    return {flat(camera_from_world(camera)), flat(clip_from_camera(camera))};
}

}  // namespace zproof::api
