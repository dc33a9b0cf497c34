#include "tests/diagnosis/unseen_caster.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace zproof::test {
namespace {

using Corners = std::array<glm::dvec3, 3>;

Corners corners_world(const Scene& scene, std::uint32_t id) {
    const auto& triangle = scene.triangles[id];
    const auto& p_world = scene.vertices.position_world;
    return {glm::dvec3(p_world[triangle.x]), glm::dvec3(p_world[triangle.y]),
            glm::dvec3(p_world[triangle.z])};
}

glm::dvec3 ray_world(const View& view, const glm::dvec2& p_raster) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    return (w.left + (w.right - w.left) * p_raster.x / view.width) * c.right +
           (w.top - (w.top - w.bottom) * p_raster.y / view.height) * c.up - c.back;
}

/// Moeller and Trumbore (1997).
std::optional<CasterHit> meet(const Corners& p, const glm::dvec3& eye, const glm::dvec3& ray,
                              std::uint32_t id) {
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0], across = cross(ray, e2), from = eye - p[0];
    const double determinant = dot(e1, across);
    if (determinant == 0) return std::nullopt;
    const glm::dvec3 q = cross(from, e1);
    return CasterHit{dot(e2, q) / determinant, id, dot(from, across) / determinant,
                     dot(ray, q) / determinant};
}

/// In the order of the triangles.
std::vector<CasterHit> hits_along(const Scene& scene, const View& view, const glm::dvec3& ray,
                                  const CasterDefect& defect) {
    std::vector<CasterHit> hits;
    for (std::uint32_t id = 0; id < scene.triangles.size(); ++id) {
        if (defect.draws && !defect.draws(scene, id)) continue;
        const auto hit = meet(corners_world(scene, id), glm::dvec3(view.camera.eye_world), ray, id);
        const double least = defect.least_weight;
        if (hit && hit->u >= least + defect.least_u && hit->v >= least && hit->u + hit->v <= 1 - least &&
            hit->camera_depth >= view.camera.near_depth && hit->camera_depth <= view.camera.far_depth)
            hits.push_back(*hit);
    }
    return hits;
}

const CasterHit* nearest(const std::vector<CasterHit>& hits) {
    const auto found = std::ranges::min_element(hits, {}, &CasterHit::camera_depth);
    return found == hits.end() ? nullptr : &*found;
}

const CasterHit* second_nearest(const std::vector<CasterHit>& hits) {
    const CasterHit* first = nearest(hits);
    const CasterHit* second = nullptr;
    for (const CasterHit& hit : hits)
        if (&hit != first && (second == nullptr || hit.camera_depth < second->camera_depth)) second = &hit;
    return second == nullptr ? first : second;
}

bool is_prime(std::uint32_t n) {
    for (std::uint32_t d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
    return n >= 2;
}

// ---- what becomes of a frame

using Change = std::function<void(const Scene&, const View&, Frame&)>;

Change each_depth(std::function<double(double depth, int x, int y, const View&)> changed) {
    return [changed = std::move(changed)](const Scene&, const View& view, Frame& frame) {
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                if (float& depth = frame.camera_depth.at(x, y); depth != background_depth)
                    depth = float(changed(double(depth), x, y, view));
    };
}

Change each_id(
    std::function<std::uint32_t(std::uint32_t id, std::uint32_t count, int x, const View&)> changed) {
    return [changed = std::move(changed)](const Scene& scene, const View& view, Frame& frame) {
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                if (PrimitiveId& id = frame.primitive.at(x, y); id != PrimitiveId::none)
                    id = PrimitiveId(
                        changed(std::uint32_t(id), std::uint32_t(scene.triangles.size()), x, view));
    };
}

Change blank_where(std::function<bool(int x, int y, const View&)> is_blank) {
    return [is_blank = std::move(is_blank)](const Scene&, const View& view, Frame& frame) {
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x)
                if (is_blank(x, y, view)) {
                    frame.primitive.at(x, y) = PrimitiveId::none;
                    frame.camera_depth.at(x, y) = background_depth;
                }
    };
}

/// The depth of the corners that each pixel's triangle has, made one.
Change depth_of_corners(std::function<double(std::array<double, 3>)> one) {
    return [one = std::move(one)](const Scene& scene, const View& view, Frame& frame) {
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const PrimitiveId id = frame.primitive.at(x, y);
                if (id == PrimitiveId::none) continue;
                std::array<double, 3> depth{};
                const Corners corners = corners_world(scene, std::uint32_t(id));
                std::ranges::transform(corners, depth.begin(), [&](const glm::dvec3& p) {
                    return dot(glm::dvec3(view.camera.eye_world) - p, view.camera.back);
                });
                frame.camera_depth.at(x, y) = float(one(depth));
            }
    };
}

void scale_window(View& view, double x, double y) {
    Window& w = view.camera.window;
    w.left *= x, w.right *= x, w.top *= y, w.bottom *= y;
}

glm::dvec2 centre(int x, int y) { return {x + 0.5, y + 0.5}; }

/// Neighbours change places.
int partner(int i, int count) { return (i ^ 1) < count ? i ^ 1 : i; }

glm::dvec2 barrel(const View& view, int x, int y) {
    const glm::dvec2 size(view.width, view.height), from_middle = centre(x, y) / size - 0.5;
    return (0.5 + from_middle * (1 + 0.05 * dot(from_middle, from_middle))) * size;
}

void roll(View& view) {
    const double angle = std::numbers::pi / 1800;
    const glm::dvec3 right = view.camera.right, up = view.camera.up;
    view.camera.right = std::cos(angle) * right + std::sin(angle) * up;
    view.camera.up = std::cos(angle) * up - std::sin(angle) * right;
}

}  // namespace

const std::vector<CasterDefect>& caster_defects() {
    static const std::string some = "some triangles are not drawn";
    static const std::vector<CasterDefect> all{
        {.name = "none", .true_names = {}},
        {.name = "focal length off by a hundredth",
         .true_names = {"the window is scaled"},
         .camera = [](View& v) { scale_window(v, 1.01, 1.01); }},
        {.name = "window of two more rows",
         .true_names = {"the window is scaled in y"},
         .camera = [](View& v) { scale_window(v, 1, 1 + 2.0 / v.height); }},
        {.name = "principal point 3 px aside",
         .true_names = {"the principal point lies elsewhere"},
         .p_raster = [](const View&, int x, int y) { return centre(x - 3, y); }},
        {.name = "window twice as high",
         .true_names = {"the window is twice as high"},
         .camera = [](View& v) { scale_window(v, 1, 2); }},
        {.name = "far a tenth nearer",
         .true_names = {"the far plane lies nearer", some},
         .camera = [](View& v) { v.camera.far_depth = 0.9 * std::min(v.camera.far_depth, 12.0); }},
        {.name = "near farther",
         .true_names = {"the near plane lies farther"},
         .camera = [](View& v) { v.camera.near_depth *= 1.3; }},
        {.name = "rolled by a tenth of a degree", .true_names = {"the camera is turned"}, .camera = roll},
        {.name = "eye a thousandth aside",
         .true_names = {"the camera stands elsewhere"},
         .camera = [](View& v) { v.camera.eye_world += glm::vec3(1e-3 * v.camera.right); }},
        {.name = "pairs of columns exchanged",
         .true_names = {},
         .p_raster = [](const View& v, int x, int y) { return centre(partner(x, v.width), y); }},
        {.name = "pairs of rows exchanged in some tiles",
         .true_names = {},
         .p_raster = [](const View& v, int x,
                        int y) { return centre(x, (x / 8 + y / 8) % 5 == 0 ? partner(y, v.height) : y); }},
        {.name = "barrel distortion", .true_names = {"the image is distorted radially"}, .p_raster = barrel},
        {.name = "odd triangles lost",
         .true_names = {some},
         .draws = [](const Scene&, std::uint32_t id) { return id % 2 == 0; }},
        {.name = "prime triangles lost",
         .true_names = {some},
         .draws = [](const Scene&, std::uint32_t id) { return !is_prime(id); }},
        {.name = "last part lost",
         .true_names = {"triangles beyond a count are not drawn", some, "some parts are not drawn"},
         .draws = [](const Scene& s,
                     std::uint32_t id) { return s.parts.empty() || id < s.parts.back().first_triangle; }},
        {.name = "one weight down to -0.01", .true_names = {}, .least_u = -0.01},
        {.name = "weights below 0.01 missed", .true_names = {}, .least_weight = 0.01},
        {.name = "the second hit is shown",
         .true_names = {"the depth test is reversed"},
         .shown = second_nearest},
        {.name = "any hit is shown",
         .true_names = {"the depth test is missing: the first drawn wins"},
         .shown = [](const auto& hits) { return hits.empty() ? nullptr : &hits.front(); }},
        {.name = "the last hit is shown",
         .true_names = {"the depth test is missing: the last drawn wins"},
         .shown = [](const auto& hits) { return hits.empty() ? nullptr : &hits.back(); }},
        {.name = "depth squared", .true_names = {}, .after = each_depth([](double z, int, int, const View&) {
                                                        return z * z;
                                                    })},
        {.name = "depth to the power of 1 / 2.2",
         .true_names = {"depth went through a curve of gamma 2.2"},
         .after = each_depth([](double z, int, int, const View&) { return std::pow(z, 1 / 2.2); })},
        {.name = "depth halved at the right",
         .true_names = {},
         .after =
             each_depth([](double z, int x, int, const View& v) { return 2 * x > v.width ? z / 2 : z; })},
        {.name = "depth off in every third row",
         .true_names = {},
         .after = each_depth([](double z, int, int y, const View&) { return y % 3 == 1 ? z * 1.0005 : z; })},
        {.name = "depth biased",
         .true_names = {"depth is biased by a constant"},
         .after = each_depth([](double z, int, int, const View&) { return z - 1e-3; })},
        {.name = "depth of the centroid",
         .true_names = {"a triangle has one depth"},
         .after = depth_of_corners([](const auto& d) { return (d[0] + d[1] + d[2]) / 3; })},
        {.name = "depth of the nearest corner",
         .true_names = {},
         .after = depth_of_corners([](const auto& d) { return std::ranges::min(d); })},
        {.name = "ids two too large",
         .true_names = {"ids are exchanged"},
         .after = each_id([](std::uint32_t id, std::uint32_t n, int, const View&) { return (id + 2) % n; })},
        {.name = "the second bit of ids turned",
         .true_names = {"ids are exchanged"},
         .after = each_id([](std::uint32_t id, std::uint32_t n, int, const View&) { return (id ^ 2) % n; })},
        {.name = "ids of six bits",
         .true_names = {"several triangles have one id"},
         .after = each_id([](std::uint32_t id, std::uint32_t, int, const View&) { return id & 63; })},
        {.name = "the next id at the left",
         .true_names = {},
         .after = each_id([](std::uint32_t id, std::uint32_t n, int x, const View& v) {
             return 2 * x < v.width ? (id + 1) % n : id;
         })},
        {.name = "a blank circle", .true_names = {}, .after = blank_where([](int x, int y, const View& v) {
                                                         return std::hypot(x - 0.4 * v.width,
                                                                           y - 0.5 * v.height) < 40;
                                                     })},
        {.name = "a blank diagonal", .true_names = {}, .after = blank_where([](int x, int y, const View&) {
                                                           return std::abs(x - y - 20) < 6;
                                                       })},
        {.name = "the lower quarter blank",
         .true_names = {"the last rows are missing"},
         .after = blank_where([](int, int y, const View& v) { return y >= 3 * v.height / 4; })},
    };
    return all;
}

Frame cast(const Scene& scene, const View& seen, const CasterDefect& defect) {
    View view = seen;
    if (defect.camera) defect.camera(view);
    Frame frame({view.width, view.height});
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const glm::dvec2 p_raster = defect.p_raster ? defect.p_raster(view, x, y) : centre(x, y);
            const auto hits = hits_along(scene, view, ray_world(view, p_raster), defect);
            const CasterHit* hit = defect.shown ? defect.shown(hits) : nearest(hits);
            if (hit == nullptr) continue;
            frame.primitive.at(x, y) = PrimitiveId(hit->id);
            frame.camera_depth.at(x, y) = float(hit->camera_depth);
        }
    if (defect.after) defect.after(scene, seen, frame);
    return frame;
}

}  // namespace zproof::test
