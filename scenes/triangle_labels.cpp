#include "scenes/triangle_labels.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "frame/did_you_mean.h"
#include "frame/input_file.h"
#include "frame/joined.h"
#include "scenes/cryptomatte.h"
#include "scenes/json_text.h"
#include "scenes/refusal.h"
#include "scenes/scene_files.h"

namespace zproof {

namespace {

/// A part's label, and the name that it is known by; empty: none.
struct PartLabel {
    std::uint32_t label;
    std::string name;
};

const std::string& material_name(const Scene& scene, const Part& part) {
    return scene.materials.at(std::size_t(part.material)).name;
}

PartLabel by_hash(const std::string& name) { return {cryptomatte_id(name), name}; }

/// A word for labels that the scene itself knows.
struct Kind {
    const char* word;
    /// `primitive`: the part's index among those that have triangles.
    PartLabel (*label)(const Scene& scene, const Part& part, std::uint32_t primitive);
    bool is_hash = false;
};

constexpr std::array kinds{
    Kind{"primitive",
         [](const Scene&, const Part& part, std::uint32_t primitive) {
             return PartLabel{primitive, part.node};
         }},
    Kind{"node",
         [](const Scene&, const Part& part, std::uint32_t) {
             return PartLabel{std::uint32_t(part.node_index), part.node};
         }},
    Kind{"material",
         [](const Scene& scene, const Part& part, std::uint32_t) {
             return PartLabel{std::uint32_t(part.material), material_name(scene, part)};
         }},
    Kind{"cryptomatte-object",
         [](const Scene&, const Part& part, std::uint32_t) { return by_hash(part.node); }, true},
    Kind{"cryptomatte-material",
         [](const Scene& scene, const Part& part, std::uint32_t) {
             return by_hash(material_name(scene, part));
         },
         true},
};

TriangleLabels labels_by(const Kind& kind, const Scene& scene) {
    TriangleLabels labels{.ids = kind.word,
                          .of_triangle = std::vector<std::uint32_t>(scene.triangles.size())};
    if (kind.is_hash) labels.background.push_back(0);
    std::uint32_t primitive = 0;
    for (const Part& part : scene.parts) {
        if (part.triangle_count == 0) continue;
        const auto [label, name] = kind.label(scene, part, primitive++);
        std::fill_n(labels.of_triangle.begin() + part.first_triangle, part.triangle_count, label);
        if (!name.empty()) labels.names.emplace(label, name);
    }
    return labels;
}

}  // namespace

const std::vector<std::string>& label_words() {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> all{"triangle", "none"};
        for (const Kind& kind : kinds) all.emplace_back(kind.word);
        return all;
    }();
    return words;
}

std::string fault_of_label_word(const std::string& word) {
    if (std::ranges::count(label_words(), word) > 0) return "";
    const std::string fault = fault_of_input(word);
    return fault.empty()
               ? ""
               : fault + "; expected " + joined(label_words()) +
                     " or a JSON file with a label for each triangle" + did_you_mean(word, label_words());
}

TriangleLabels label_triangles(const std::string& word, const Scene& scene) {
    if (word == "none")
        return {.ids = word,
                .of_triangle = std::vector<std::uint32_t>(scene.triangles.size()),
                .are_absent = true};
    const auto kind = std::ranges::find_if(kinds, [&](const Kind& k) { return k.word == word; });
    if (kind != kinds.end()) return labels_by(*kind, scene);
    return {.ids = word, .of_triangle = read_label_file(word, scene.triangles.size())};
}

namespace {

using nlohmann::json;
using Path = std::filesystem::path;

constexpr std::uint64_t largest_file = std::uint64_t{1} << 28;
constexpr const char* what_a_list_holds =
    "expected a label for each triangle, [0, 0, 7], or runs of them, [{\"count\": 12, \"label\": 7}]";

std::uint32_t whole_number(const Path& file, const std::string& place, const json& value) {
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
        refuse(file, place, "expected a whole number from 0 to 4294967295");
    return std::uint32_t(value.get<std::uint64_t>());
}

/// The labels in the making.
class LabelList {
  public:
    LabelList(const Path& file, std::size_t triangles) : file_(file), triangles_(triangles) {
        labels_.reserve(triangles);
    }

    void add(std::size_t index, const json& value) {
        const std::string place = "/" + std::to_string(index);
        if (!value.is_object()) return add(place, 1, whole_number(file_, place, value));
        if (value.size() != 2 || !value.contains("count") || !value.contains("label"))
            refuse(file_, place, R"(expected an object with "count" and "label")");
        add(place, whole_number(file_, place + "/count", value["count"]),
            whole_number(file_, place + "/label", value["label"]));
    }

    std::vector<std::uint32_t> take() {
        if (labels_.size() < triangles_)
            refuse(file_, "/",
                   "labels for " + std::to_string(labels_.size()) + " triangles; the scene has " +
                       std::to_string(triangles_));
        return std::move(labels_);
    }

  private:
    void add(const std::string& place, std::size_t count, std::uint32_t label) {
        if (label == std::numeric_limits<std::uint32_t>::max())
            refuse(file_, place, "4294967295 means background; expected another label");
        if (count > triangles_ - labels_.size())
            refuse(file_, place,
                   "a label beyond the last of the scene's " + std::to_string(triangles_) + " triangles");
        labels_.insert(labels_.end(), count, label);
    }

    const Path& file_;
    std::size_t triangles_;
    std::vector<std::uint32_t> labels_;
};

}  // namespace

std::vector<std::uint32_t> read_label_file(const Path& file, std::size_t triangles) {
    const Bytes text = read_file(file, largest_file);
    const json list = parse_json(file, text_in(file, text));
    if (!list.is_array()) refuse(file, "/", what_a_list_holds);
    LabelList labels(file, triangles);
    for (std::size_t i = 0; i < list.size(); ++i) labels.add(i, list[i]);
    return labels.take();
}

}  // namespace zproof
