/// The built-in suite: scenes made by our own generator, each there for a reason that the manifest states.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frame/plane.h"
#include "scenes/loaded.h"

namespace zproof {

struct SuiteEntry {
    std::string name;                  ///< unique; also the scene's name
    std::string reason;                ///< one sentence: what this scene can catch
    std::vector<std::string> expects;  ///< pixel classes that must occur, e.g. "edge", "clip"
    std::optional<Resolution> size;    ///< of its pictures in a run that names none; nothing: 1920 x 1080
};

/// The manifest (scenes/suite/manifest.json, compiled into the library), in order.
std::vector<SuiteEntry> suite_manifest();

/// Builds one suite scene with its views; the same bits every time. Throws SceneError for an unknown name.
Loaded generate_suite_scene(const std::string& name, int width = 1920, int height = 1080);

}  // namespace zproof
