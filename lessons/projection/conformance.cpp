#include "lessons/projection/conformance.h"

#include <algorithm>

namespace zproof::study::projection {

namespace {

/// (2, -1, 2) / 3 and so on: a rotation without rounding.
std::array<Vector3<Rational>, 3> turned_axes() {
    const Rational a = Rational(2) / 3, b = Rational(1) / 3;
    return {{{a, -b, a}, {a, a, -b}, {-b, a, a}}};
}

ProbeCamera probe(std::string name, Projection projection, const Canvas<Rational>& canvas,
                  const Rational& near) {
    ProbeCamera probe{std::move(name), {}};
    NumericCamera<Rational>& camera = probe.camera;
    camera.projection = projection;
    camera.eye = {Rational(1) / 2, Rational(-3) / 4, Rational(5)};
    camera.to_camera = turned_axes();
    camera.canvas = canvas;
    const Rational at = projection == Projection::perspective ? near : Rational(1);
    camera.on_near = {at * canvas.left, at * canvas.right, at * canvas.bottom, at * canvas.top};
    camera.shear = {Rational(0), Rational(0)};
    camera.near = near, camera.far = Rational(100);
    camera.width = Rational(640), camera.height = Rational(480);
    return probe;
}

/// Numerical Recipes' generator: small whole numbers, the same everywhere.
class Draw {
  public:
    int operator()(int low, int high) {
        state_ = state_ * 1664525u + 1013904223u;
        return low + int((state_ >> 8) % std::uint32_t(high - low + 1));
    }

  private:
    std::uint32_t state_ = 6;
};

Vector3<Rational> in_camera(const NumericCamera<Rational>& camera, const Vector3<Rational>& p_world) {
    const Vector3<Rational> p = p_world - camera.eye;
    return {dot(camera.to_camera[0], p), dot(camera.to_camera[1], p), dot(camera.to_camera[2], p)};
}

/// (u, v) of scenes/camera.h: where a point of this space lies in the window.
Point2<Rational> in_window(Space space, const NumericCamera<Rational>& camera, const Point4<Rational>& p) {
    const Canvas<Rational>& c = camera.canvas;
    const Rational across = c.right - c.left, up = c.top - c.bottom;
    switch (space) {
        case Space::clip:
            return in_window(Space::ndc, camera, {p[0] / p[3], p[1] / p[3], p[2] / p[3], Rational(1)});
        case Space::screen: {
            const Rational at = camera.projection == Projection::perspective ? camera.near : Rational(1);
            return {p[0] / at, p[1] / at};
        }
        case Space::ndc:
            return {c.left + across * (p[0] + 1) / 2, c.bottom + up * (p[1] + 1) / 2};
        case Space::unit_ndc:
            return {c.left + across * p[0], c.bottom + up * p[1]};
        case Space::raster:
            return {c.left + across * p[0] / camera.width, c.top - up * p[1] / camera.height};
        case Space::camera:
        case Space::screen_at_one:
            return {p[0], p[1]};
    }
    return {};
}

/// The view ray through (u, v) at the point's depth t: t (u, v) or (u, v) + t shear.
bool sees(const NumericCamera<Rational>& camera, const Point2<Rational>& window,
          const Vector3<Rational>& p_camera) {
    const Rational t = -p_camera.z;
    if (camera.projection == Projection::perspective)
        return t * window.x == p_camera.x && t * window.y == p_camera.y;
    return window.x + t * camera.shear.x == p_camera.x && window.y + t * camera.shear.y == p_camera.y;
}

double distance_px(const Point2<Rational>& a, const Point2<Rational>& b) {
    return static_cast<double>(std::max(magnitude(a.x - b.x), magnitude(a.y - b.y)));
}

/// Notes the first stage that ends elsewhere than the exact projection has it; true where none does.
bool try_point(const Route<Rational>& route, const ProbeCamera& probe, const Vector3<Rational>& p_world,
               RouteFinding& finding) {
    Travel<Rational> travel = departure(p_world);
    bool is_kept = true;
    for (const Operation<Rational>& operation : route.operations) {
        travel = operation.apply(travel);
        if (!operation.arrives || is_on_view_ray(*operation.arrives, probe.camera, p_world, travel)) continue;
        is_kept = false;
        if (!finding.is_projection()) continue;
        finding.first_wrong_stage = operation.stage, finding.operation = operation.name;
        finding.space = in_words(*operation.arrives), finding.camera = probe.name;
    }
    const Point2<Rational> reached{travel.at[0], travel.at[1]};
    finding.worst_px = std::max(finding.worst_px, distance_px(reached, exact_raster(probe.camera, p_world)));
    return is_kept;
}

RouteFinding begun(const RouteCard& card) {
    RouteFinding finding;
    finding.card = card;
    return finding;
}

void try_camera(const ProbeCamera& probe, std::vector<RouteFinding>& findings) {
    const std::vector<Vector3<Rational>> points = probe_points(probe.camera);
    for (const Route<Rational>& route : routes(probe.camera)) {
        auto finding =
            std::ranges::find(findings, route.card.name, [](const RouteFinding& f) { return f.card.name; });
        if (finding == findings.end()) finding = findings.insert(findings.end(), begun(route.card));
        bool is_kept = true;
        for (const Vector3<Rational>& p : points) is_kept = try_point(route, probe, p, *finding) && is_kept;
        ++finding->cameras;
        finding->cameras_kept += is_kept ? 1 : 0;
    }
}

bool is_within(const Rational& a, const Rational& half) { return magnitude(a) <= half; }

void try_place(const VisibilityTest& test, const Point2<Rational>& p, VisibilityFinding& finding) {
    const Rational width(2), height(2);
    const bool is_called = test.calls_visible(p, width, height);
    const bool is_on = -width <= 2 * p.x && 2 * p.x <= width && -height <= 2 * p.y && 2 * p.y <= height;
    ++finding.points;
    if (is_called == is_on) return;
    (is_called ? finding.shown_wrongly : finding.hidden_wrongly) += 1;
    if (finding.example.empty())
        finding.example = "(" + p.x.str() + ", " + p.y.str() + ") on a canvas of 2 x 2 is called " +
                          (is_called ? "visible" : "invisible");
}

}  // namespace

std::vector<ProbeCamera> probe_cameras() {
    const auto q = [](int a, int b) { return Rational(a) / b; };
    const Canvas<Rational> two{-1, 1, -1, 1}, narrow{q(-2, 3), q(2, 3), q(-1, 2), q(1, 2)},
        off_axis{q(-1, 4), q(3, 2), q(-1, 8), q(7, 8)};
    std::vector<ProbeCamera> all{
        probe("canvas 2 x 2, near 1", Projection::perspective, two, 1),
        probe("canvas 2 x 2, near 1/10", Projection::perspective, two, q(1, 10)),
        probe("canvas 4/3 x 1, near 1/10", Projection::perspective, narrow, q(1, 10)),
        probe("off axis, near 1/2", Projection::perspective, off_axis, q(1, 2)),
        probe("orthographic", Projection::parallel, off_axis, q(1, 2)),
        probe("oblique", Projection::parallel, narrow, q(1, 2))};
    all.back().camera.shear = {q(1, 4), q(-1, 3)};
    return all;
}

std::vector<Vector3<Rational>> probe_points(const NumericCamera<Rational>& camera) {
    constexpr int count = 60;
    Draw draw;
    std::vector<Vector3<Rational>> points;
    for (int i = 0; i < count; ++i) {
        const Rational x = Rational(draw(-64, 64)) / 16, y = Rational(draw(-64, 64)) / 16,
                       depth = Rational(draw(1, 80)) / 16;
        points.push_back(camera.eye + x * camera.to_camera[0] + y * camera.to_camera[1] -
                         depth * camera.to_camera[2]);
    }
    return points;
}

bool is_on_view_ray(Space space, const NumericCamera<Rational>& camera, const Vector3<Rational>& p_world,
                    const Travel<Rational>& travel) {
    const Point4<Rational>& p = travel.at;
    if (space == Space::camera) {
        const Vector3<Rational> back_in_world =
            camera.eye + p[0] * camera.to_camera[0] + p[1] * camera.to_camera[1] + p[2] * camera.to_camera[2];
        return back_in_world.x == p_world.x && back_in_world.y == p_world.y && back_in_world.z == p_world.z;
    }
    if (p[3] == 0) return false;
    return sees(camera, in_window(space, camera, p), in_camera(camera, p_world));
}

Point2<Rational> exact_raster(const NumericCamera<Rational>& camera, const Vector3<Rational>& p_world) {
    const Vector3<Rational> p = in_camera(camera, p_world);
    const Rational t = -p.z;
    const bool is_perspective = camera.projection == Projection::perspective;
    const Rational u = is_perspective ? p.x / t : p.x - t * camera.shear.x;
    const Rational v = is_perspective ? p.y / t : p.y - t * camera.shear.y;
    const Canvas<Rational>& c = camera.canvas;
    return {(u - c.left) / (c.right - c.left) * camera.width,
            (c.top - v) / (c.top - c.bottom) * camera.height};
}

std::vector<RouteFinding> route_findings() {
    std::vector<RouteFinding> findings;
    for (const ProbeCamera& probe : probe_cameras()) try_camera(probe, findings);
    return findings;
}

std::vector<VisibilityTest> visibility_tests() {
    constexpr const char* lesson = "Scratchapixel, Computing the Pixel Coordinates of a 3D Point";
    return {
        {"half, and", "|x| <= W/2 and |y| <= H/2", "what a canvas means",
         [](const auto& p, const auto& w, const auto& h) {
             return is_within(p.x, w / 2) && is_within(p.y, h / 2);
         }},
        {"half, or", "|x| <= W/2 or |y| <= H/2", std::string{lesson} + ", the formula of the text",
         [](const auto& p, const auto& w, const auto& h) {
             return is_within(p.x, w / 2) || is_within(p.y, h / 2);
         }},
        {"whole canvas", "not (|x| > W or |y| > H)", std::string{lesson} + ", lines 24 and 25 of the listing",
         [](const auto& p, const auto& w, const auto& h) { return is_within(p.x, w) && is_within(p.y, h); }}};
}

std::vector<VisibilityFinding> visibility_findings() {
    constexpr int reach = 12, per_half = 8;  // to 1.5 times the whole canvas of 2 x 2
    std::vector<VisibilityFinding> findings;
    for (const VisibilityTest& test : visibility_tests()) {
        VisibilityFinding finding;
        finding.name = test.name, finding.formula = test.formula, finding.source = test.source;
        for (int j = -reach; j <= reach; ++j)
            for (int i = -reach; i <= reach; ++i)
                try_place(test, {Rational(2 * i) / per_half, Rational(2 * j) / per_half}, finding);
        findings.push_back(std::move(finding));
    }
    return findings;
}

}  // namespace zproof::study::projection
