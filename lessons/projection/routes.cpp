#include "lessons/projection/routes.h"

#include "lessons/projection/matrices.h"
#include "lessons/projection/stages.h"

namespace zproof::study::projection {

namespace {

constexpr const char* pixel_lesson = "Scratchapixel, Computing the Pixel Coordinates of a 3D Point";
constexpr const char* stage_lesson = "Scratchapixel, The Projection Stage";

template <class Number>
using Step = std::function<Vector3<Number>(const Vector3<Number>&)>;

/// Puts a route together, operation by operation.
template <class Number>
class Builder {
  public:
    Builder(const RouteCard& card) { route_.card = card; }

    Builder& stage(std::string name) {
        stage_ = std::move(name);
        return *this;
    }
    /// An operation on x, y and z.
    Builder& then(std::string name, Step<Number> step) {
        add(std::move(name), [step](const Travel<Number>& t) {
            const Vector3<Number> p = step({t.at[0], t.at[1], t.at[2]});
            return Travel<Number>{{p.x, p.y, p.z, Number(1)}, t.screen};
        });
        return *this;
    }
    Builder& by_matrix(std::string name, const Matrix4<Number>& m) {
        add(std::move(name), [m](const Travel<Number>& t) { return Travel<Number>{m * t.at, t.screen}; });
        return *this;
    }
    Builder& add(std::string name, std::function<Travel<Number>(const Travel<Number>&)> apply) {
        route_.operations.push_back({stage_, std::move(name), std::nullopt, std::move(apply)});
        return *this;
    }
    /// What was added last ends its stage here.
    Builder& in(Space space) {
        route_.operations.back().arrives = space;
        return *this;
    }
    Route<Number> route() { return std::move(route_); }

  private:
    Route<Number> route_;
    std::string stage_;
};

template <class Number>
void to_camera(Builder<Number>& b, const NumericCamera<Number>& camera) {
    b.stage("world to camera")
        .then("minus the eye", [camera](const auto& p) { return less_eye(camera, p); })
        .then("along the axes", [camera](const auto& p) { return along_axes(camera, p); })
        .in(Space::camera);
}

/// Screen space, and a note of it for whoever goes back to it.
template <class Number>
void to_screen(Builder<Number>& b, const NumericCamera<Number>& camera) {
    b.stage("camera to screen");
    if (camera.projection == Projection::parallel)
        b.then("along the shear", [camera](const auto& p) { return along_shear(camera, p); });
    else
        b.then("near x", [camera](const auto& p) {
             return times_near(camera, p);
         }).then("divide by -z", [](const auto& p) { return over_depth(p); });
    b.in(Space::screen);
}

template <class Number>
void to_ndc(Builder<Number>& b, const NumericCamera<Number>& camera) {
    const Canvas<Number> c = camera.on_near;
    b.stage("screen to NDC")
        .then("2 x / (r - l)", [c](const auto& p) { return double_over_extent(c, p); })
        .then("minus (r + l) / (r - l)", [c](const auto& p) { return less_middle(c, p); })
        .in(Space::ndc);
}

template <class Number>
void ndc_to_raster(Builder<Number>& b, const NumericCamera<Number>& camera) {
    b.stage("NDC to raster")
        .then("(x + 1) / 2, (1 - y) / 2", [](const auto& p) { return halved_from_top(p); })
        .then("times W, H", [camera](const auto& p) { return times_pixels(camera, p); })
        .in(Space::raster);
}

template <class Number>
void unit_ndc_to_raster(Builder<Number>& b, const NumericCamera<Number>& camera) {
    b.stage("NDC to raster")
        .then("1 - y", [](const auto& p) { return from_top(p); })
        .then("times W, H", [camera](const auto& p) { return times_pixels(camera, p); })
        .in(Space::raster);
}

template <class Number>
Route<Number> by_stages(const NumericCamera<Number>& camera) {
    Builder<Number> b{
        {"stages", "Stage by stage, NDC [-1, 1] by l, r, b, t on the near plane.", stage_lesson}};
    to_camera(b, camera), to_screen(b, camera), to_ndc(b, camera), ndc_to_raster(b, camera);
    return b.route();
}

template <class Number>
Route<Number> by_unit_stages(const NumericCamera<Number>& camera) {
    const Canvas<Number> c = camera.on_near;
    Builder<Number> b{
        {"stages-unit", "Stage by stage, NDC [0, 1] by l, r, b, t on the near plane.", stage_lesson}};
    to_camera(b, camera), to_screen(b, camera);
    b.stage("screen to NDC")
        .then("x - l, y - b", [c](const auto& p) { return less_corner(c, p); })
        .then("divide by r - l, t - b", [c](const auto& p) { return over_extent(c, p); })
        .in(Space::unit_ndc);
    unit_ndc_to_raster(b, camera);
    return b.route();
}

template <class Number>
Route<Number> by_canvas(const NumericCamera<Number>& camera) {
    const Canvas<Number> c = camera.canvas;
    Builder<Number> b{
        {"canvas", "A canvas of width W and height H at depth 1 about the axis, NDC [0, 1].", pixel_lesson}};
    to_camera(b, camera);
    b.stage("camera to screen")
        .then("divide by -z", [](const auto& p) { return over_depth(p); })
        .in(Space::screen_at_one);
    b.stage("screen to NDC")
        .then("x + W / 2", [c](const auto& p) { return plus_half_extent(c, p); })
        .then("divide by W, H", [c](const auto& p) { return over_extent(c, p); })
        .in(Space::unit_ndc);
    unit_ndc_to_raster(b, camera);
    return b.route();
}

template <class Number>
void divide_and_scale(Builder<Number>& b, const NumericCamera<Number>& camera) {
    b.stage("clip to NDC")
        .add("divide by w",
             [](const Travel<Number>& t) {
                 const Number& w = t.at[3];
                 return Travel<Number>{{t.at[0] / w, t.at[1] / w, t.at[2] / w, Number(1)}, t.screen};
             })
        .in(Space::ndc);
    b.stage("NDC to raster").by_matrix("viewport matrix", viewport_matrix(camera)).in(Space::raster);
}

template <class Number>
Route<Number> by_matrices(const NumericCamera<Number>& camera) {
    Builder<Number> b{{"matrices", "A 4 x 4 matrix for each stage.", stage_lesson}};
    b.stage("world to camera").by_matrix("camera matrix", camera_matrix(camera)).in(Space::camera);
    b.stage("camera to clip").by_matrix("projection matrix", projection_matrix(camera)).in(Space::clip);
    divide_and_scale(b, camera);
    return b.route();
}

template <class Number>
Route<Number> by_one_matrix(const NumericCamera<Number>& camera) {
    Builder<Number> b{
        {"one-matrix", "Camera and projection multiplied into one 4 x 4 matrix.", "usual practice"}};
    b.stage("world to clip")
        .by_matrix("projection x camera matrix", projection_matrix(camera) * camera_matrix(camera))
        .in(Space::clip);
    divide_and_scale(b, camera);
    return b.route();
}

/// The listing of 2021: NDC coordinates are worked out and then not used.
template <class Number>
Route<Number> raster_from_screen(const NumericCamera<Number>& camera) {
    Builder<Number> b{{"raster-from-screen",
                       "The listing of 2021 maps screen coordinates, not NDC coordinates, to raster space.",
                       stage_lesson, RouteKind::slip}};
    to_camera(b, camera), to_screen(b, camera);
    b.add("note it", [](const Travel<Number>& t) {
         return Travel<Number>{t.at, {t.at[0], t.at[1]}};
     }).in(Space::screen);
    to_ndc(b, camera);
    b.stage("NDC to raster")
        .add("(x_screen + 1) / 2, (1 - y_screen) / 2",
             [](const Travel<Number>& t) {
                 const Vector3<Number> p = halved_from_top<Number>({t.screen.x, t.screen.y, t.at[2]});
                 return Travel<Number>{{p.x, p.y, p.z, Number(1)}, t.screen};
             })
        .then("times W, H", [camera](const auto& p) { return times_pixels(camera, p); })
        .in(Space::raster);
    return b.route();
}

/// The chapter's first form of the divide, before it mends it: P.x / P.z mirrors the picture.
template <class Number>
Route<Number> divided_by_z(const NumericCamera<Number>& camera) {
    Builder<Number> b{{"divided-by-z",
                       "The chapter's first form of the divide, x / z, which it mends itself.", pixel_lesson,
                       RouteKind::slip}};
    to_camera(b, camera);
    b.stage("camera to screen")
        .then("near x", [camera](const auto& p) { return times_near(camera, p); })
        .then("divide by z",
              [](const Vector3<Number>& p) {
                  return Vector3<Number>{p.x / p.z, p.y / p.z, -p.z};
              })
        .in(Space::screen);
    to_ndc(b, camera), ndc_to_raster(b, camera);
    return b.route();
}

template <class Number>
bool is_centred(const Canvas<Number>& c) {
    return c.left == -c.right && c.bottom == -c.top;
}

}  // namespace

std::string in_words(Space space) {
    switch (space) {
        case Space::camera:
            return "camera";
        case Space::clip:
            return "clip";
        case Space::screen:
            return "screen, on the near plane";
        case Space::screen_at_one:
            return "screen, at depth 1";
        case Space::ndc:
            return "NDC [-1, 1]";
        case Space::unit_ndc:
            return "NDC [0, 1]";
        case Space::raster:
            return "raster";
    }
    return "";
}

template <class Number>
std::vector<Route<Number>> routes(const NumericCamera<Number>& camera) {
    std::vector<Route<Number>> all{by_stages(camera), by_unit_stages(camera), by_matrices(camera),
                                   by_one_matrix(camera)};
    const bool is_perspective = camera.projection == Projection::perspective;
    if (is_perspective && is_centred(camera.canvas)) all.push_back(by_canvas(camera));
    all.push_back(raster_from_screen(camera));
    if (is_perspective) all.push_back(divided_by_z(camera));
    return all;
}

template std::vector<Route<float>> routes(const NumericCamera<float>& camera);
template std::vector<Route<double>> routes(const NumericCamera<double>& camera);
template std::vector<Route<Rational>> routes(const NumericCamera<Rational>& camera);

}  // namespace zproof::study::projection
