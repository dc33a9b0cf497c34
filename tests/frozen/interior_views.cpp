#include "tests/frozen/interior_views.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace zproof::frozen {
namespace {

using nlohmann::json;

glm::dvec3 vector_of(const json& numbers) {
    return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

View view_of(const json& facts, const std::string& name, Resolution size) {
    View view{.name = name, .camera = {}, .width = size.width, .height = size.height};
    view.camera =
        look_at(vector_of(facts.at("eye")), vector_of(facts.at("target")), vector_of(facts.at("up")));
    const double yfov_radians = glm::radians(facts.at("yfov_degrees").get<double>());
    view.camera.window = symmetric_window(yfov_radians, double(size.width) / size.height);
    view.camera.near_depth = facts.at("znear").get<double>();
    view.camera.far_depth = facts.at("zfar").get<double>();
    return view;
}

}  // namespace

std::map<std::string, std::vector<View>> interior_views(const std::filesystem::path& folder,
                                                        Resolution size) {
    std::map<std::string, std::vector<View>> by_model;
    const std::filesystem::path file = folder / "interior_views.json";
    if (!std::filesystem::exists(file)) return by_model;
    for (const json& model : json::parse(std::ifstream(file))) {
        std::vector<View>& views = by_model[model.at("model").get<std::string>()];
        for (const json& facts : model.at("views"))
            views.push_back(view_of(facts, "inside_" + std::to_string(views.size()), size));
    }
    return by_model;
}

}  // namespace zproof::frozen
