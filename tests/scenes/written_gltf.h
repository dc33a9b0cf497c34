/// Small glTF files written by a test into a folder of its own.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/gltf/gltf.h"
#include "scenes/scene_error.h"
#include "tests/support/test_folder.h"

namespace zproof {

/// A glTF in the making: buffer 0 lies in scene.bin; every add_ gives the accessor's index.
class WrittenGltf {
  public:
    nlohmann::json json = {{"asset", {{"version", "2.0"}}},
                           {"scene", 0},
                           {"scenes", {{{"nodes", {0}}}}},
                           {"nodes", {{{"mesh", 0}}}},
                           {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
                           {"accessors", nlohmann::json::array()},
                           {"bufferViews", nlohmann::json::array()}};

    template <typename T>
    int add_view(const std::vector<T>& values) {
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        const std::size_t offset = bytes_.size();
        bytes_.resize(offset + values.size() * sizeof(T));
        std::memcpy(bytes_.data() + offset, values.data(), values.size() * sizeof(T));
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }

    int add_accessor(nlohmann::json accessor) {
        json["accessors"].push_back(std::move(accessor));
        return static_cast<int>(json["accessors"].size()) - 1;
    }

    /// Tightly packed VEC3 of FLOAT.
    int add_vec3(const std::vector<float>& values) {
        return add_accessor({{"bufferView", add_view(values)},
                             {"componentType", 5126},
                             {"count", values.size() / 3},
                             {"type", "VEC3"}});
    }

    template <typename T>
    int add_indices(const std::vector<T>& values, int component_type) {
        return add_accessor({{"bufferView", add_view(values)},
                             {"componentType", component_type},
                             {"count", values.size()},
                             {"type", "SCALAR"}});
    }

    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }

    std::filesystem::path write(const TestFolder& folder) const {
        nlohmann::json whole = json;
        whole["buffers"] = {{{"uri", "scene.bin"}, {"byteLength", bytes_.size()}}};
        folder.write("scene.bin", std::string(bytes_.begin(), bytes_.end()));
        return folder.write("scene.gltf", whole.dump());
    }

  private:
    std::vector<char> bytes_;
};

/// What is said of a file that is refused.
inline std::string refusal_of(const std::filesystem::path& file) {
    try {
        load_gltf(file);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "loaded";
}

}  // namespace zproof
