/// Scenes to compare texture filters on: textures made in code, on surfaces that ask for every anisotropy and
/// every level. They are no part of the gate's suite. docs/filter-scenes.md shows the list.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/loaded.h"

namespace zproof {

struct FilterSceneEntry {
    std::string name;    ///< unique; also the scene's name
    std::string reason;  ///< one sentence: what the scene asks of a filter
};

/// The scenes in the order of the documentation.
std::vector<FilterSceneEntry> filter_scenes();

/// Builds one of them with its views; the same bits every time. Throws SceneError for an unknown name.
Loaded generate_filter_scene(const std::string& name, int width = 512, int height = 512);

/// Is it by its name a file of texels: PNG, JPEG, OpenEXR or DDS?
bool is_photograph(const std::filesystem::path& file);

/// Is it one whose samples are floats? Throws FrameError where it cannot be read.
bool is_photograph_of_floats(const std::filesystem::path& file);

/// The plane of `checker_plane` with such a file as its texture, 128 texels to a unit; the scene is
/// named after the file, "rocket.jpg". Throws SceneError where the file cannot be read.
Loaded photograph_scene(const std::filesystem::path& file, int width = 512, int height = 512);

/// That plane with an image that is no file's.
Loaded plane_scene(const std::string& name, Image image, int width = 512, int height = 512);

}  // namespace zproof
