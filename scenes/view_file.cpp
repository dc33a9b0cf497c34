#include "scenes/view_file.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "scenes/json_text.h"
#include "scenes/model_file.h"
#include "scenes/refusal.h"
#include "scenes/scene_error.h"
#include "scenes/scene_files.h"
#include "scenes/view_document.h"

namespace zproof {
namespace {

using Path = std::filesystem::path;

using nlohmann::json;

constexpr std::uint64_t largest_view_file = std::uint64_t{1} << 24;
constexpr std::size_t most_views = 1000;
constexpr int largest_side = 16384;

template <typename T>
T choice(const LocatedValue& place, std::initializer_list<std::pair<std::string_view, T>> choices) {
    std::string list;
    for (const auto& [name, value] : choices) {
        if (place.value().is_string() && place.text() == name) return value;
        list += (list.empty() ? "\"" : ", \"") + std::string(name) + "\"";
    }
    place.fail("expected one of " + list);
}

enum class ProjectionKind { perspective, orthographic, oblique, parallel };

ProjectionKind projection_kind(const LocatedValue& view) {
    return choice<ProjectionKind>(view.at("projection"), {{"perspective", ProjectionKind::perspective},
                                                          {"orthographic", ProjectionKind::orthographic},
                                                          {"oblique", ProjectionKind::oblique},
                                                          {"parallel", ProjectionKind::parallel}});
}

Window window_at(const LocatedValue& place) {
    place.allow({"left", "right", "bottom", "top"});
    const Window window{place.at("left").number(), place.at("right").number(), place.at("bottom").number(),
                        place.at("top").number()};
    if (!(window.left < window.right && window.bottom < window.top))
        place.fail("expected left < right and bottom < top");
    return window;
}

double positive_number(const LocatedValue& place) {
    if (!(place.number() > 0)) place.fail("expected a number above 0");
    return place.number();
}

Window window_of_field(const LocatedValue& view, double aspect) {
    const LocatedValue yfov = view.at("yfov_degrees");
    if (!(yfov.number() > 0 && yfov.number() < 180)) yfov.fail("expected an angle between 0 and 180 degrees");
    return symmetric_window(yfov.number() * std::numbers::pi / 180, aspect);
}

/// The window on the plane at depth 1 is the one on the near plane, scaled by 1 / near.
Window window_at_near(const LocatedValue& view) {
    const Window w = window_at(view.at("near_window"));
    const double near = positive_number(view.at("near"));
    return {w.left / near, w.right / near, w.bottom / near, w.top / near};
}

Window window_of_magnification(const LocatedValue& view) {
    const double x = positive_number(view.at("xmag")), y = positive_number(view.at("ymag"));
    return {-x, x, -y, y};
}

Window window_of(const LocatedValue& view, ProjectionKind kind, double aspect) {
    const int forms = view.has("yfov_degrees") + view.has("near_window") + view.has("exact_window") +
                      (view.has("xmag") || view.has("ymag"));
    const bool is_perspective = kind == ProjectionKind::perspective;
    if (forms == 1 && view.has("exact_window")) return window_at(view.at("exact_window"));
    if (forms == 1 && is_perspective && view.has("yfov_degrees")) return window_of_field(view, aspect);
    if (forms == 1 && is_perspective && view.has("near_window")) return window_at_near(view);
    if (forms == 1 && !is_perspective && view.has("xmag")) return window_of_magnification(view);
    view.fail(is_perspective
                  ? "expected exactly one of \"yfov_degrees\", \"near_window\" and \"exact_window\""
                  : "expected either \"xmag\" and \"ymag\" or \"exact_window\"");
}

glm::dvec2 shear_of(const LocatedValue& view, ProjectionKind kind) {
    if (kind == ProjectionKind::oblique || (kind == ProjectionKind::parallel && view.has("shear"))) {
        const json& shear = view.at("shear").numbers(2);
        return {shear[0].get<double>(), shear[1].get<double>()};
    }
    if (view.has("shear"))
        view.at("shear").fail("only \"oblique\" and \"parallel\" projections have a shear");
    return glm::dvec2(0);
}

void set_pose(const LocatedValue& view, Camera& camera) {
    const bool has_target = view.has("target"), has_axes = view.has("right") || view.has("back");
    const glm::dvec3 eye = view.at("eye").vector(), up = view.at("up").vector();
    if (has_target == has_axes)
        view.fail("expected either \"target\" and \"up\" or \"right\", \"up\" and \"back\"");
    if (has_target) {
        camera = look_at(eye, view.at("target").vector(), up);
        return;
    }
    camera.eye_world = glm::vec3(eye);
    camera.right = view.at("right").vector();
    camera.up = up;
    camera.back = view.at("back").vector();
}

double far_of(const LocatedValue& view) {
    const LocatedValue far = view.at("far");
    if (far.value() == "infinity") return std::numeric_limits<double>::infinity();
    if (!far.value().is_number()) far.fail("expected a number or \"infinity\"");
    return far.number();
}

Camera camera_of(const LocatedValue& view, double aspect) {
    const ProjectionKind kind = projection_kind(view);
    Camera camera;
    set_pose(view, camera);
    camera.projection = kind == ProjectionKind::perspective ? Projection::perspective : Projection::parallel;
    camera.window = window_of(view, kind, aspect);
    camera.shear = shear_of(view, kind);
    camera.near_depth = view.at("near").number();
    camera.far_depth = far_of(view);
    if (view.has("ndc_depth"))
        camera.ndc_depth = choice<NdcDepth>(view.at("ndc_depth"),
                                            {{"minus_one_to_one", NdcDepth::minus_one_to_one},
                                             {"zero_to_one", NdcDepth::zero_to_one},
                                             {"zero_to_one_reversed", NdcDepth::zero_to_one_reversed}});
    validate(camera);
    return camera;
}

int side_of(const LocatedValue& view, const char* key, int otherwise) {
    if (!view.has(key)) return otherwise;
    const LocatedValue side = view.at(key);
    if (!side.value().is_number_unsigned() || side.value() < 1 || side.value() > largest_side)
        side.fail("expected an integer from 1 to " + std::to_string(largest_side));
    return side.value().get<int>();
}

View view_at(const LocatedValue& place) {
    place.allow({"back", "exact_window", "eye", "far", "height", "name", "ndc_depth", "near", "near_window",
                 "projection", "right", "shear", "target", "up", "width", "xmag", "yfov_degrees", "ymag"});
    View view;
    view.name = place.at("name").text();
    if (view.name.size() > 64 || view.name != view_name(view.name))
        place.at("name").fail("expected 1 to 64 letters, digits, '-', '_', '.', the first not a '.'");
    view.width = side_of(place, "width", view.width);
    view.height = side_of(place, "height", view.height);
    try {
        view.camera = camera_of(place, static_cast<double>(view.width) / view.height);
    } catch (const SceneError& error) {
        const std::string what = error.what();
        if (!what.starts_with("camera ")) throw;  // it names the file already
        place.fail(what);
    }
    return view;
}

std::vector<View> views_at(const LocatedValue& list) {
    const std::size_t size = list.value().is_array() ? list.value().size() : 0;
    if (size < 1 || size > most_views)
        list.fail("expected an array of 1 to " + std::to_string(most_views) + " views");
    std::vector<View> views;
    std::set<std::string> names;
    for (std::size_t i = 0; i < size; ++i) {
        views.push_back(view_at(list.at(i)));
        if (!names.insert(views.back().name).second)
            list.at(i).at("name").fail("expected a name that no other view has");
    }
    return views;
}

Path model_of(const Path& file, const std::string& relative, const Path& models) {
    if (!models.empty()) return beneath_folder_or_root(file, "/scene", relative, models);
    return beneath_folder_of(file, "/scene", relative,
                             "put the model beneath the view file's folder, or name its own: --models DIR");
}

}  // namespace

Loaded load_view_file(const std::filesystem::path& file, const std::filesystem::path& models) {
    const Bytes bytes = read_file(file, largest_view_file);
    const json content = parse_json(file, text_in(file, bytes));
    const LocatedValue root(file, content, "");
    root.allow({"scene", "views"});
    std::vector<View> views = views_at(root.at("views"));
    return {load_model_scene(model_of(file, root.at("scene").text(), models)), std::move(views)};
}

}  // namespace zproof
