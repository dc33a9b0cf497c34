/// Triangles that are missing, or drawn where they should not be.
#include <algorithm>
#include <cmath>
#include <map>

#include "tests/reports_from_the_field/field_frames.h"
#include "tests/reports_from_the_field/field_scenes.h"
#include "tests/reports_from_the_field/ray_caster.h"

namespace zproof::field_reports {

namespace {

using Rebuild = std::function<Shown()>;

/// Draws only what `keeps` says of the view and a triangle.
Rebuild keeping(Scene scene, View view, std::function<bool(const View&, const CameraTriangle&)> keeps) {
    return [=] {
        return Shown{scene, view,
                     cast(scene, view, {.draws = [&](const CameraTriangle& t) { return keeps(view, t); }})};
    };
}

bool is_beyond_near(const View& view, const CameraTriangle& t) {
    return std::ranges::all_of(t.p_camera,
                               [&](const glm::dvec3& p) { return p.z >= view.camera.near_depth; });
}

bool is_before_far(const View& view, const CameraTriangle& t) {
    return std::ranges::all_of(t.p_camera, [&](const glm::dvec3& p) { return p.z <= view.camera.far_depth; });
}

bool is_before_eye(const View&, const CameraTriangle& t) {
    return std::ranges::all_of(t.p_camera, [](const glm::dvec3& p) { return p.z > 0; });
}

bool is_within_sides(const View& view, const CameraTriangle& t) {
    return is_before_eye(view, t) && std::ranges::all_of(t.p_camera, [&](const glm::dvec3& p) {
               const glm::dvec2 at = raster_position(view, p);
               return at.x >= 0 && at.y >= 0 && at.x <= view.width && at.y <= view.height;
           });
}

bool is_within_sides_in_parallel(const View& view, const CameraTriangle& t) {
    return std::ranges::all_of(t.p_camera, [&](const glm::dvec3& p) {
        const glm::dvec2 at = raster_position(view, p);
        return at.x >= 0 && at.y >= 0 && at.x <= view.width && at.y <= view.height;
    });
}

/// A triangle does not show where its box ends less than `limit_px` beyond the centre.
Shown with_short_boxes(double limit_px, bool in_x, bool in_y) {
    const Scene scene = yard();
    const View view = view_of_yard();
    const auto covers = [=](const CameraTriangle& t, int x, int y) {
        glm::dvec2 end(-1e9);
        for (const glm::dvec3& p : t.p_camera) {
            if (p.z < 1e-3) return true;
            end = max(end, raster_position(view, p));
        }
        return !(in_x && end.x - (x + 0.5) < limit_px) && !(in_y && end.y - (y + 0.5) < limit_px);
    };
    return {scene, view, cast(scene, view, {.covers = covers})};
}

View near_the_ground() {
    View view = view_of_yard();
    view.camera.near_depth = 3.9;
    return view;
}

/// Where the camera stands on a square of the ground.
View view_on_the_ground() {
    View view = view_ahead(50, 96, 72, 0.3, 60);
    view.camera.eye_world = {0.1f, 0.2f, 2.2f};
    return view;
}

/// With a triangle across the near plane, all of it before the eye.
Scene yard_with_plank() {
    Scene scene = yard();
    const auto first = std::uint32_t(scene.vertices.position_world.size());
    for (const glm::vec3& p :
         {glm::vec3(-0.3f, 0.1f, 2.05f), glm::vec3(-0.25f, 0.1f, 1.3f), glm::vec3(-0.1f, 0.15f, 1.3f)})
        scene.vertices.position_world.push_back(p);
    scene.triangles.push_back({first, first + 1, first + 2});
    ++scene.parts.back().triangle_count;
    return scene;
}

View with_far(double far_depth) {
    View view = view_of_yard();
    view.camera.far_depth = far_depth;
    return view;
}

/// Triangles of the hills are about a pixel large.
View far_hills() {
    View view = view_of_yard(120, 90);
    const Camera aimed = look_at({1, 4, 11}, {0, 0, 0}, {0, 1, 0});
    view.camera.eye_world = aimed.eye_world;
    view.camera.right = aimed.right;
    view.camera.up = aimed.up;
    view.camera.back = aimed.back;
    return view;
}

Shown with_least_determinant(double least) {
    const Scene scene = hills(60);
    const View view = far_hills();
    return {scene, view, cast(scene, view, {.least_determinant = least})};
}

/// The hills, a hundredth as large, so that determinants lie about 1e-6.
Shown small_hills_with_least_determinant(double least) {
    Scene scene = hills(60);
    for (glm::vec3& p : scene.vertices.position_world) p *= 0.01f;
    View view = far_hills();
    view.camera.eye_world *= 0.01f;
    view.camera.near_depth = 0.01;
    view.camera.far_depth = 1;
    return {scene, view, cast(scene, view, {.least_determinant = least})};
}

/// Counter-clockwise faces are left out.
bool is_seen_from_behind(const View&, const CameraTriangle& t) {
    const glm::dvec3 normal = cross(t.p_camera[1] - t.p_camera[0], t.p_camera[2] - t.p_camera[0]);
    return dot(normal, t.p_camera[0]) < 0;  // right, up, depth: a left-handed frame
}

Shown grown(double by_px) {
    const Scene scene = yard();
    const View view = view_of_yard();
    return {scene, view, cast(scene, view, {.grown_px = by_px})};
}

/// A centre on an edge is nobody's.
Shown without_shared_edges(const Scene& scene, const View& view) {
    const auto covers = [&](const CameraTriangle& t, int x, int y) {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 p = raster_position(view, t.p_camera[i]),
                             edge = raster_position(view, t.p_camera[(i + 1) % 3]) - p,
                             to = glm::dvec2(x + 0.5, y + 0.5) - p;
            if (std::abs(edge.x * to.y - edge.y * to.x) < 1e-9 * length(edge)) return false;
        }
        return true;
    };
    return {scene, view, cast(scene, view, {.covers = covers})};
}

/// 4 x 4 squares at depth 3, whose sides and diagonals pass through centres of pixels 1/16 wide.
Scene wall() {
    Scene scene = hills(4);
    for (glm::vec3& p : scene.vertices.position_world) p = {p.x + 1.0f / 32, p.z + 1.0f / 32, -3};
    return scene;
}

/// Its blocks of 8 x 8 px hide what is farther than the nearest depth of the triangles drawn so far there,
/// though it should be the farthest.
Shown with_stale_hierarchical_z() {
    const Scene scene = yard();
    const View view = view_of_yard();
    Frame frame({view.width, view.height});
    std::map<std::pair<int, int>, float> nearest_of_block;
    for (std::uint32_t only = 0; only < scene.triangles.size(); ++only) {
        const Frame one = cast(scene, view, {.draws = [&](const CameraTriangle& t) { return t.id == only; }});
        std::map<std::pair<int, int>, float> nearest_here;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const float depth = one.camera_depth.at(x, y);
                const std::pair block{x / 8, y / 8};
                if (depth == background_depth || depth >= frame.camera_depth.at(x, y)) continue;
                if (nearest_of_block.contains(block) && depth > nearest_of_block[block]) continue;
                frame.primitive.at(x, y) = PrimitiveId(only);
                frame.camera_depth.at(x, y) = depth;
                const auto [entry, is_new] = nearest_here.try_emplace(block, depth);
                entry->second = std::min(entry->second, depth);
            }
        for (const auto& [block, depth] : nearest_here) {
            const auto [entry, is_new] = nearest_of_block.try_emplace(block, depth);
            entry->second = std::min(entry->second, depth);
        }
    }
    return {scene, view, frame};
}

/// Vertices above 65 535 are looked up by their low 16 bits.
Shown with_indices_of_16_bits() {
    const Scene scene = hills(299);
    Scene wrapped = scene;
    for (glm::uvec3& t : wrapped.triangles) t = t & 0xFFFFu;
    View view = view_of_yard();
    view.camera.eye_world.y = 3;
    return {scene, view, cast(wrapped, view)};
}

/// A cache of 64 vertices by the low bits of the index, whose tag forgets bit 6: it takes a vertex for
/// another that is 64 further.
Shown with_stale_vertex_cache() {
    const Scene scene = hills(40);
    Scene drawn = scene;
    std::map<std::uint32_t, std::uint32_t> cached;  // vertex by slot
    for (glm::uvec3& t : drawn.triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t slot = t[k] & 0x3Fu;
            const auto found = cached.find(slot);
            const bool is_hit = found != cached.end() && (found->second & ~0x40u) == (t[k] & ~0x40u);
            if (!is_hit) cached[slot] = t[k];
            t[k] = cached[slot];
        }
    const View view = far_hills();
    return {scene, view, cast(drawn, view)};
}

}  // namespace

std::vector<FieldFrame> frames_of_drawing() {
    const RayPrecision ray{.arithmetic = Arithmetic::float32};
    const auto area_above = [](double least) {
        return [=](const View& view, const CameraTriangle& t) {
            return std::abs(double_area_px2(view, t)) >= least;
        };
    };
    return {
        {"across_near",
         {"triangles across the near plane are dropped"},
         "pytorch3d #345: faces with a vertex behind the camera are not rendered",
         keeping(one_triangle({-1, 0, 0}, {-1, 1, -0.1f}, {0, 0, -1}), view_ahead(60, 400, 400, 0.01, 100),
                 is_beyond_near)},
        {"across_near_in_the_yard",
         {"triangles across the near plane are dropped"},
         "bullet3 #1006: TinyRenderer discards a triangle that straddles the near plane",
         keeping(yard(), near_the_ground(), is_beyond_near)},
        {"behind_the_eye",
         {"triangles with a corner behind the eye are dropped"},
         "pytorch3d #467: faces with a z below kEpsilon are left out",
         keeping(yard_with_plank(), view_on_the_ground(), is_before_eye)},
        {"across_far",
         {"triangles across the far plane are dropped"},
         "zproof #43: the same at the far plane",
         keeping(yard(), with_far(6.3), is_before_far)},
        {"across_a_side",
         {"triangles across a side of the picture are dropped"},
         "tyra #14: a triangle partially outside of the frustum is discarded whole",
         keeping(yard(), view_of_yard(64, 48), is_within_sides)},
        {"across_a_side_of_a_caster",
         {"triangles across a side of the picture are dropped"},
         "tyra #14, of a renderer that declares rays",
         keeping(yard(), view_of_yard(96, 64), is_within_sides),
         ray},
        {"below_half_a_pixel",
         {"triangles of less than 1/2 px^2 are dropped"},
         "nvdiffrast #89: a tiny triangle is discarded by a wrong test; zproof #43: determinant below 1",
         keeping(hills(60), far_hills(), area_above(1))},
        {"below_an_area",
         {"small triangles are dropped"},
         "nvdiffrast #89, with another limit",
         keeping(hills(60), far_hills(), area_above(1.37))},
        {"determinant_below_1e_2",
         {"triangles with a small determinant are dropped"},
         "vector_math.dart #43: 10e-5 rejects hits; here fitted to a scene of 8 units",
         [] { return with_least_determinant(0.016); },
         ray},
        {"below_a_pixel",
         {"triangles of less than 1 px^2 are dropped"},
         "nvdiffrast #89, with a limit of a pixel",
         keeping(hills(60), far_hills(), area_above(2))},
        {"determinant_below_1e_6",
         {"triangles of a determinant below 1e-6 are dropped"},
         "tinybvh PR #283: fabs(a) < 1e-6 in Moeller and Trumbore's test",
         [] { return small_hills_with_least_determinant(1e-6); },
         ray},
        {"across_far_of_a_caster",
         {"triangles across the far plane are dropped"},
         "zproof #43: the same at the far plane, of a renderer that declares rays",
         keeping(yard(), with_far(5.1), is_before_far),
         ray},
        {"across_a_side_in_parallel",
         {"triangles across a side of the picture are dropped"},
         "tyra #14, in an orthographic view",
         keeping(yard(), parallel_view_of_yard(1.3, 1, 78, 60), is_within_sides_in_parallel)},
        {"front_faces",
         {"front faces are dropped"},
         "zproof #43: culling of the wrong side",
         keeping(yard(), view_of_yard(), is_seen_from_behind)},
        {"beyond_a_count",
         {"triangles beyond a count are not drawn"},
         "zproof #43: triangles beyond a count are lost",
         keeping(yard(), view_of_yard(), [](const View&, const CameraTriangle& t) { return t.id < 464; })},
        {"conservative_over",
         {"triangles show wherever they touch a pixel"},
         "zproof #43: conservative rasterization left on",
         [] { return grown(0.5); }},
        {"conservative_under",
         {"triangles show only where they cover a pixel whole"},
         "zproof #43: conservative rasterization, the inner one",
         [] { return grown(-0.5); }},
        {"box_without_its_last_column",
         {"triangles lose the last column of their bounding box"},
         "a loop that ends before the last centre",
         [] { return with_short_boxes(1, true, false); }},
        {"box_without_its_last_row",
         {"triangles lose the last row of their bounding box"},
         "a loop that ends before the pixel in which the box ends",
         [] { return with_short_boxes(0.5, false, true); }},
        {"box_without_both",
         {"triangles lose the last column and row of their bounding box"},
         "the same, for both",
         [] { return with_short_boxes(0.5, true, true); }},
        {"biased_depth_test",
         {"a later triangle hides an earlier one only by a bias"},
         "a depth test with an epsilon",
         [] {
             const Scene scene = yard();
             const View view = view_of_yard();
             return Shown{scene, view, cast(scene, view, {.lead = 0.04})};
         }},
        {"edges_owned_by_nobody",
         {"the top-left rule is missing"},
         "strict inequalities: a centre on the square's diagonal is in neither half",
         [] { return without_shared_edges(square_ahead(2, 1.5f), view_ahead(60, 64, 64, 0.01, 100)); }},
        {"edges_owned_by_nobody_of_a_caster",
         {"the top-left rule is missing"},
         "the same for every edge of a wall of 16 squares, of a renderer that declares rays",
         [] { return without_shared_edges(wall(), parallel_view_ahead(2, 2, 64, 64, 0.1, 10)); },
         ray},
        {"stale_hierarchical_z",
         {"what is hidden is decided for blocks of 8 px"},
         "zproof #43: hierarchical z that is stale after a near triangle",
         with_stale_hierarchical_z},
        {"indices_of_16_bits",
         {"vertex indices keep their low 16 bits"},
         "GLTFUtility #87: meshes with more than 65 536 vertices are drawn from wrong vertices",
         with_indices_of_16_bits},
        {"stale_vertex_cache",
         {"triangles are drawn with another's vertex"},
         "zproof #43: a vertex cache that returns another vertex",
         with_stale_vertex_cache},
    };
}

}  // namespace zproof::field_reports
