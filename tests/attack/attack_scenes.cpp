#include "tests/attack/attack_scenes.h"

#include <algorithm>

#include "scenes/random_scenes.h"
#include "scenes/suite.h"
#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/random.h"

namespace zproof::attack {

namespace {

using suite::MeshBuilder;
using suite::Random;
using Corners = std::array<glm::dvec3, 3>;  ///< raster x and y, px, and camera depth

constexpr int width = 24, height = 16;

/// A pixel is a unit of the image plane; the eye is at `eye`.
View pixel_view(Projection projection, const glm::vec3& eye = glm::vec3(0)) {
    View view{.name = "attack", .camera = {}, .width = width, .height = height};
    view.camera.projection = projection;
    view.camera.eye_world = eye;
    const bool is_perspective = projection == Projection::perspective;
    // a field of view of about 90 degrees; a parallel view has units of a pixel
    const double unit = is_perspective ? 1.0 / 16 : 1;
    view.camera.window = {.left = -width / 2 * unit,
                          .right = width / 2 * unit,
                          .bottom = -height / 2 * unit,
                          .top = height / 2 * unit};
    view.camera.near_depth = is_perspective ? 0.25 : -32;
    view.camera.far_depth = is_perspective ? 1024 : 64;
    return view;
}

class Builder {
  public:
    Builder(std::string name, const View& view) : name_(name), mesh_(name), view_(view) {
        mesh_.begin_part("attack", glm::vec3(1));
    }

    glm::dvec3 world(const glm::dvec3& at) const {
        const Camera& c = view_.camera;
        const bool is_perspective = c.projection == Projection::perspective;
        const double scale = is_perspective ? at.z : 1;
        const double u = c.window.left + (c.window.right - c.window.left) * at.x / width,
                     v = c.window.top - (c.window.top - c.window.bottom) * at.y / height;
        const glm::dvec2 sheared = is_perspective ? glm::dvec2(0) : at.z * c.shear;
        return glm::dvec3(c.eye_world) + glm::dvec3(u * scale + sheared.x, v * scale + sheared.y, -at.z);
    }
    void triangle(const Corners& at) { mesh_.lone_triangle({world(at[0]), world(at[1]), world(at[2])}); }
    void quad(const std::array<glm::dvec3, 4>& at) {
        mesh_.quad({vertex(at[0]), vertex(at[1]), vertex(at[2]), vertex(at[3])});
    }
    std::uint32_t vertex(const glm::dvec3& at) { return mesh_.vertex(world(at)); }
    MeshBuilder& mesh() { return mesh_; }
    /// Covers the picture.
    void wall(double depth) {
        quad({glm::dvec3(-9, -9, depth),
              {width + 9, -9, depth},
              {width + 9, height + 9, depth},
              {-9, height + 9, depth}});
    }
    AttackScene finish() {
        Loaded loaded = mesh_.finish({view_});
        return {name_, std::move(loaded.scene), view_};
    }

  private:
    std::string name_;
    MeshBuilder mesh_;
    View view_;
};

glm::dvec3 anywhere(Random& dice, double depth) {
    return {dice.uniform(-2, width + 2), dice.uniform(-2, height + 2), depth};
}

AttackScene lone_silhouettes(const View& view, const std::string& name) {
    Builder b(name, view);
    Random dice(11);
    for (int i = 0; i < 3; ++i) {
        const double depth = 4 + i;
        b.triangle({anywhere(dice, depth), anywhere(dice, depth), anywhere(dice, depth)});
    }
    return b.finish();
}

/// Boxes at one place, more than any tree's leaf holds, before a wall.
AttackScene coincident_boxes(const View& view, const std::string& name) {
    Builder b(name, view);
    for (int copy = 0; copy < 12; ++copy) {
        std::array<std::uint32_t, 8> at{};
        for (std::size_t i = 0; i < 8; ++i)
            at[i] = b.vertex({i & 1 ? 17.3 : 5.2, i & 2 ? 12.1 : 3.4, i & 4 ? 8 : 6});
        for (const auto& [p, q, r, s] : std::vector<std::array<std::size_t, 4>>{
                 {0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}})
            b.mesh().quad({at[p], at[q], at[r], at[s]});
    }
    b.wall(16);
    return b.finish();
}

/// Floors that near cuts, some of them into pieces below two pixels.
AttackScene cut_by_near(const View& view, const std::string& name) {
    Builder b(name, view);
    const double near = view.camera.near_depth;
    b.mesh().lone_triangle({glm::dvec3(-1, -0.2, 1), {1, -0.3, 1}, {0.2, -0.4, -6}});
    b.mesh().lone_triangle({glm::dvec3(-1, 0.3, 2), {1, 0.2, -5}, {-1.5, 0.4, -6}});
    Random dice(12);
    for (int i = 0; i < 6; ++i) {  // a tip before near, as wide as a pixel there
        const glm::dvec3 tip = anywhere(dice, near * 1.02);
        b.triangle({tip, glm::dvec3(tip.x + dice.uniform(-60, 60), tip.y + dice.uniform(-60, 60), near * 0.5),
                    glm::dvec3(tip.x + dice.uniform(-60, 60), tip.y + dice.uniform(-60, 60), near * 0.5)});
    }
    b.wall(10);
    return b.finish();
}

/// Walls in planes through the eye, and some that almost are.
AttackScene edge_on(const View& view, const std::string& name) {
    Builder b(name, view);
    b.triangle({glm::dvec3(12, 2, 3), {12, 14, 3}, {12, 8, 6}});
    b.triangle({glm::dvec3(4.5, 2, 4), {4.5, 14, 4}, {4.5, 9, 2}});
    b.triangle({glm::dvec3(18, 1, 3), {18, 12, 3}, {18 + 0x1p-9, 6, 5}});
    b.wall(12);
    return b.finish();
}

AttackScene needles(const View& view, const std::string& name) {
    Builder b(name, view);
    Random dice(13);
    for (int i = 0; i < 24; ++i) {
        const glm::dvec3 from = anywhere(dice, dice.uniform(2, 6)), to = anywhere(dice, dice.uniform(2, 6));
        const double apart = dice.binade(-12, 0);
        b.triangle({from, to, to + glm::dvec3(apart, dice.uniform(-1, 1) * apart, 0)});
    }
    b.wall(12);
    return b.finish();
}

/// A surface of triangles smaller than a pixel.
AttackScene below_a_pixel(const View& view, const std::string& name) {
    Builder b(name, view);
    Random dice(14);
    constexpr int side = 12;
    std::vector<std::uint32_t> at;
    for (int i = 0; i < side * side; ++i)
        at.push_back(b.vertex({6 + 0.6 * (i % side) + dice.uniform(-0.1, 0.1),
                               4 + 0.6 * (i / side) + dice.uniform(-0.1, 0.1), dice.uniform(4, 4.5)}));
    for (std::size_t y = 0; y + 1 < side; ++y)
        for (std::size_t x = 0; x + 1 < side; ++x)
            b.mesh().quad(
                {at[y * side + x], at[y * side + x + 1], at[(y + 1) * side + x + 1], at[(y + 1) * side + x]});
    return b.finish();
}

/// Strips that abut without a shared edge, and a T-junction.
AttackScene abutting(const View& view, const std::string& name) {
    Builder b(name, view);
    b.quad({glm::dvec3(2, 1, 4), {9.5, 1, 4}, {9.5, 15, 4}, {2, 15, 4}});
    b.quad({glm::dvec3(9.5, 0, 4), {20, 0, 4}, {20, 8, 4}, {9.5, 8, 4}});
    b.quad({glm::dvec3(9.5, 8, 4), {20, 8, 4}, {20, 16, 4}, {9.5, 16, 4}});
    b.triangle({glm::dvec3(3, 2, 6), {21, 4, 6}, {8, 15, 6}});
    return b.finish();
}

/// Corners half a step of the grid beside it, and walls a small step apart in depth.
AttackScene half_steps(const View& view, const std::string& name) {
    Builder b(name, view);
    Random dice(15);
    const auto at = [&](double depth) {
        const glm::dvec3 p = anywhere(dice, depth);
        return glm::dvec3(std::floor(p.x * 256) / 256 + 0x1p-9, std::floor(p.y * 256) / 256 + 0x1p-9, depth);
    };
    for (int i = 0; i < 12; ++i) {
        const double depth = 4 + i * 0x1p-21;
        b.triangle({at(depth), at(depth), at(depth)});
    }
    return b.finish();
}

View sampled(View view) {
    view.sample.offset_px = {-0.375, 0.125};
    return view;
}

View far_away(Projection projection) { return pixel_view(projection, glm::vec3(1e6f, -7e5f, 3e5f)); }

View oblique() {
    View view = pixel_view(Projection::parallel);
    view.camera.shear = {0.3, -0.7};
    return view;
}

}  // namespace

std::vector<AttackScene> hand_made_scenes() {
    std::vector<AttackScene> all;
    const std::vector<std::pair<std::string, View>> views{
        {"perspective", pixel_view(Projection::perspective)},
        {"parallel", pixel_view(Projection::parallel)},
        {"oblique", oblique()},
        {"sampled", sampled(pixel_view(Projection::perspective))}};
    const std::vector<std::pair<std::string, AttackScene (*)(const View&, const std::string&)>> kinds{
        {"lone_silhouettes", lone_silhouettes},
        {"coincident_boxes", coincident_boxes},
        {"cut_by_near", cut_by_near},
        {"edge_on", edge_on},
        {"needles", needles},
        {"below_a_pixel", below_a_pixel},
        {"abutting", abutting},
        {"half_steps", half_steps}};
    for (const auto& [of_view, view] : views)
        for (const auto& [of_kind, make] : kinds) all.push_back(make(view, of_kind + "/" + of_view));
    for (const Projection p : {Projection::perspective, Projection::parallel})
        all.push_back(
            lone_silhouettes(far_away(p), p == Projection::perspective ? "far_eye" : "far_eye/parallel"));
    return all;
}

std::vector<AttackScene> small_suite_scenes(std::size_t most_triangles) {
    std::vector<AttackScene> all;
    for (const SuiteEntry& entry : suite_manifest()) {
        if (entry.has_own_sizes) continue;
        const Loaded loaded = generate_suite_scene(entry.name, 36, 20);
        if (loaded.scene.triangles.size() > most_triangles) continue;
        for (const View& view : loaded.views)
            all.push_back({entry.name + "/" + view.name, loaded.scene, view});
    }
    return all;
}

AttackScene random_attack_scene(std::uint64_t seed, std::uint64_t number) {
    const RandomScene named = random_scene(any_random_kind, seed, number);
    Loaded loaded = generate(named);
    View view = loaded.views.front();
    view.width = std::min(view.width, 48);
    view.height = std::min(view.height, 48);
    return {word_of(named), std::move(loaded.scene), view};
}

}  // namespace zproof::attack
