#include "scenes/label_file.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "scenes/json_text.h"
#include "scenes/refusal.h"
#include "scenes/scene_files.h"

namespace zproof {
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
    const json list = parse_json(file, {reinterpret_cast<const char*>(text.data()), text.size()});
    if (!list.is_array()) refuse(file, "/", what_a_list_holds);
    LabelList labels(file, triangles);
    for (std::size_t i = 0; i < list.size(); ++i) labels.add(i, list[i]);
    return labels.take();
}

}  // namespace zproof
