#include "scenes/suite/random.h"
#include "scenes/suite/scenes.h"
#include "scenes/suite/shapes.h"

namespace zproof::suite {

namespace {

/// Houses that stand on the ground plane y = 0 within |x|, |z| < 40: every other one turned to any angle.
void add_town(MeshBuilder& mesh, Random& random) {
    mesh.begin_part("ground", {0.35, 0.35, 0.3});
    add_sheet(mesh, {.across = 20, .down = 20}, [](double s, double t) {
        return glm::dvec3{100 * s - 50, 0, 100 * t - 50};
    });
    mesh.begin_part("houses", {0.75, 0.7, 0.6});
    for (int i = 0; i < 400; ++i) {
        const int column = i % 20, row = i / 20;
        const double x = 4 * column - 38, z = 4 * row - 38, height = random.uniform(1, 9);
        const double width = random.uniform(0.6, 1.4), length = random.uniform(0.6, 1.4);
        const double tilt = i % 2 == 0 ? 0 : random.uniform(-0.6, 0.6);
        add_box(mesh, {{x, height / 2, z},
                       glm::dmat3(glm::dvec3{width, 0, tilt}, glm::dvec3{0, height / 2, 0},
                                  glm::dvec3{-tilt, 0, length})});
    }
    mesh.begin_part("domes", {0.4, 0.6, 0.7});
    for (int i = 0; i < 30; ++i) {
        const double x = 4 * random.integer(-9, 9) + 2, z = 4 * random.integer(-9, 9) + 2;
        add_sphere(mesh, {{x, 0.5, z}, glm::dmat3(random.uniform(0.8, 1.6))}, {.across = 32, .down = 16});
    }
}

/// Cards side by side, from camera depth 2e-6 to 0.1.
void add_close_cards(MeshBuilder& mesh, const Camera& camera) {
    mesh.begin_part("close cards", {0.7, 0.3, 0.5});
    double depth = 2e-6;
    for (int i = 0; i < 8; ++i, depth *= 4.5) {
        const double u = 0.2 * i - 0.8;
        const auto at = [&](double right, double up, double ahead) {
            return glm::dvec3(camera.eye_world) +
                   depth * (right * camera.right + up * camera.up - ahead * camera.back);
        };
        mesh.lone_quad({{at(u, -0.1, 1), at(u + 0.15, -0.1, 1), at(u + 0.15, 0.3, 1.5), at(u, 0.3, 1.5)}});
    }
}

}  // namespace

Loaded off_axis(ImageSize size) {
    MeshBuilder mesh("off_axis");
    Random random(16);
    add_town(mesh, random);
    const Intrinsics intrinsics{.half_height = 0.5, .near_depth = 0.5, .far_depth = 200};
    const auto shifted = [&](const char* name, double eye_x, const glm::dvec2& shift) {
        View view = perspective_view(
            name, size, {.eye_world = {eye_x, 14, 44}, .target_world = {eye_x, 5, 0}}, intrinsics);
        view.camera.window.left += shift.x;
        view.camera.window.right += shift.x;
        view.camera.window.bottom += shift.y;
        view.camera.window.top += shift.y;
        return view;
    };
    return mesh.finish({shifted("left-eye", -1.5, {0.034, 0}), shifted("right-eye", 1.5, {-0.034, 0}),
                        shifted("corner", 0, {1.1, -0.7})});
}

Loaded orthographic(ImageSize size) {
    MeshBuilder mesh("orthographic");
    Random random(17);
    add_town(mesh, random);
    return mesh.finish(
        {parallel_view("plan", size,
                       {.eye_world = {0, 50, 0}, .target_world = {0, 0, 0}, .up_world = {0, 0, -1}},
                       {.half_height = 24, .near_depth = 1, .far_depth = 100}),
         parallel_view("isometric", size, {.eye_world = {60, 60, 60}, .target_world = {0, 0, 0}},
                       {.half_height = 20, .near_depth = 1, .far_depth = 300})});
}

Loaded oblique(ImageSize size) {
    MeshBuilder mesh("oblique");
    Random random(18);
    add_town(mesh, random);
    const auto sheared = [&](const char* name, const CameraPose& pose, const glm::dvec2& shear) {
        View view = parallel_view(name, size, pose, {.half_height = 22, .near_depth = 1, .far_depth = 200});
        view.camera.shear = shear;
        const glm::dvec2 shift = shear * 60.0;  // keeps what lies at depth 60 where it was
        view.camera.window.left -= shift.x;
        view.camera.window.right -= shift.x;
        view.camera.window.bottom -= shift.y;
        view.camera.window.top -= shift.y;
        return view;
    };
    return mesh.finish(
        {sheared("cabinet", {.eye_world = {0, 4, 60}, .target_world = {0, 4, 0}}, {-0.35, -0.35}),
         sheared("military", {.eye_world = {0, 60, 0}, .target_world = {0, 0, 0}, .up_world = {0, 0, -1}},
                 {0.5, -0.75})});
}

Loaded odd_cameras(ImageSize size) {
    MeshBuilder mesh("odd_cameras");
    Random random(19);
    add_town(mesh, random);
    const View close = perspective_view("close", size, {{0, 0x1p-10, 0}, {0, 1, -0.5}},
                                        {.half_height = 0.5, .near_depth = 1e-6, .far_depth = 1000});
    add_close_cards(mesh, close.camera);
    const CameraPose street{.eye_world = {3, 6, 50}, .target_world = {0, 4, 0}};
    const auto seen = [&](const char* name, CameraPose pose, const Intrinsics& intrinsics) {
        return perspective_view(name, size, pose, intrinsics);
    };
    View rolled =
        seen("rolled", {street.eye_world, street.target_world, {0.6, -0.35, 0.1}}, {.far_depth = 200});
    View skewed = seen("skewed", street, {.far_depth = 200});
    skewed.camera.right += 4e-13 * skewed.camera.up;
    View beside = seen("beside", {{0, 40, 0}, {0, 40, -1}}, {.far_depth = 1000});
    beside.camera.window = {4, 4 + 2 * size.aspect(), -5, -3};
    const Intrinsics tenth_of_a_degree{.half_height = 8.7266e-4, .near_depth = 1000, .far_depth = 3000};
    return mesh.finish(
        {rolled, skewed, beside, seen("narrow", {{1200, 300, 1500}, {0, 3, 0}}, tenth_of_a_degree),
         seen("wide", {{0.5, 2, 0.5}, {0.3, 1, 0}}, {.half_height = 114.59, .near_depth = 0.01}), close});
}

}  // namespace zproof::suite
