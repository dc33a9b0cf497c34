#include <algorithm>
#include <cstring>

#include "frame/number_text.h"
#include "scenes/glb_writer.h"
#include "scenes/judged_ranges.h"
#include "scenes/model_file.h"
#include "scenes/suite.h"
#include "scenes/view_file.h"
#include "zproof/data.h"
#include "zproof/errors.h"
#include "zproof/names.h"

namespace zproof::api {
namespace {

static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && sizeof(glm::uvec3) == 3 * sizeof(std::uint32_t));

template <class Element, class Vector, class Scalar>
void copy_into(std::vector<Element, Vector>& to, std::span<const Scalar> from) {
    to.resize(from.size_bytes() / sizeof(Element));
    if (!from.empty()) std::memcpy(to.data(), from.data(), from.size_bytes());
}

void require(bool holds, const std::string& message) {
    if (!holds) throw InputError{"scene: " + message};
}

void require_indices(const Mesh& mesh) {
    const std::size_t vertices = mesh.positions_world.size() / 3;
    const auto beyond = std::ranges::find_if(mesh.triangles, [&](std::uint32_t i) { return i >= vertices; });
    if (beyond == mesh.triangles.end()) return;
    require(false, "triangle " + std::to_string((beyond - mesh.triangles.begin()) / 3) + " names vertex " +
                       std::to_string(*beyond) + "; there are " + std::to_string(vertices));
}

void require_lengths(const Mesh& mesh) {
    require(mesh.positions_world.size() % 3 == 0, "positions come in threes");
    require(mesh.triangles.size() % 3 == 0, "triangles come in threes");
    require(mesh.triangles.size() / 3 < background_id - 1, "more triangles than ids");
    require(mesh.uv.empty() || mesh.uv.size() / 2 == mesh.positions_world.size() / 3,
            "uv has " + std::to_string(mesh.uv.size() / 2) + " vertices, positions have " +
                std::to_string(mesh.positions_world.size() / 3));
    require(mesh.texels.empty() || !mesh.uv.empty(), "a texture needs uv");
    const auto [width, height] = mesh.texture_size;
    const bool is_absent = width == 0 && height == 0;
    require(is_absent || (width >= 1 && height >= 1 && width <= largest_side && height <= largest_side),
            "the texture is " + size_text(width, height) + "; expected 1 to 32768 texels on either side");
    require(mesh.texels.size() == 4 * mesh.texture_size.pixel_count(),
            "the texture's size is not that of its texels");
}

void add_texture(const Mesh& mesh, zproof::Scene& scene) {
    copy_into(scene.vertices.uv.emplace_back(), mesh.uv);
    if (mesh.texels.empty()) return;
    scene.images.push_back({.name = "texture",
                            .width = mesh.texture_size.width,
                            .height = mesh.texture_size.height,
                            .texels = {mesh.texels.begin(), mesh.texels.end()}});
    scene.materials.front().base_color.image = 0;
}

zproof::Scene scene_of(const Mesh& mesh) {
    require_name("scene", mesh.name);
    require_lengths(mesh);
    require_indices(mesh);
    zproof::Scene scene;
    scene.name = mesh.name;
    copy_into(scene.vertices.position_world, mesh.positions_world);
    copy_into(scene.triangles, mesh.triangles);
    const auto count = std::uint32_t(scene.triangles.size());
    scene.materials.emplace_back().name = "material";
    scene.parts.push_back(
        {.node = mesh.name, .mesh = mesh.name, .primitive = 0, .first_triangle = 0, .triangle_count = count});
    if (!mesh.uv.empty()) add_texture(mesh, scene);
    require_judged(scene);
    return scene;
}

bool is_of_suite(const std::string& name) {
    return std::ranges::count(suite_manifest(), name, &SuiteEntry::name) > 0;
}

Loaded loaded(const std::string& file_or_name, Size size) {
    if (ending_of(file_or_name) == ".json") return load_view_file(file_or_name);
    if (ending_of(file_or_name).empty() && is_of_suite(file_or_name))
        return generate_suite_scene(file_or_name, size.width, size.height);
    return load_model(file_or_name, size.width, size.height);
}

std::shared_ptr<const Scene::Data> data_of(zproof::Scene scene) {
    auto data = std::make_shared<Scene::Data>();
    data->scene = std::move(scene);
    return data;
}

}  // namespace

Scene::Scene(const Mesh& mesh) : data_(told_as_input_error([&] { return data_of(scene_of(mesh)); })) {}

Scene Scene::load(const std::string& file_or_name, Size size) {
    return told_as_input_error([&] {
        require_no_nul("load", file_or_name);
        require_size("load", size);
        Loaded from_file = loaded(file_or_name, size);
        require_judged(from_file.scene);
        auto data = std::make_shared<Data>();
        data->scene = std::move(from_file.scene);
        for (zproof::View& view : from_file.views)
            data->views.emplace_back(std::make_shared<View::Data>(View::Data{std::move(view)}));
        return Scene{std::shared_ptr<const Data>{std::move(data)}};
    });
}

void save(const Scene& scene, std::span<const View> views, const std::string& folder) {
    told_as_input_error([&] {
        Loaded loaded{scene.data().scene, {}};
        for (const View& view : views) loaded.views.push_back(view.data().view);
        write_glb(folder, loaded);
    });
}

const std::string& Scene::name() const { return data().scene.name; }
std::size_t Scene::vertex_count() const { return data().scene.vertices.position_world.size(); }
std::size_t Scene::triangle_count() const { return data().scene.triangles.size(); }
const std::vector<View>& Scene::views() const { return data().views; }
const std::vector<std::string>& Scene::notes() const { return data().scene.notes; }

std::span<const float> Scene::positions_world() const {
    const Positions& p = data().scene.vertices.position_world;
    return {p.empty() ? nullptr : &p.front().x, 3 * p.size()};
}

std::span<const std::uint32_t> Scene::triangles() const {
    const auto& t = data().scene.triangles;
    return {t.empty() ? nullptr : &t.front().x, 3 * t.size()};
}

}  // namespace zproof::api
