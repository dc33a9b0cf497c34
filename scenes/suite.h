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
    bool has_own_sizes = false;        ///< its views state their sizes, whatever a run names
};

/// The manifest (scenes/suite/manifest.json, compiled into the library): the scenes of every run, in order.
std::vector<SuiteEntry> suite_manifest();

/// The manifest's scenes that only a thorough run has, or a run that names them.
std::vector<SuiteEntry> thorough_manifest();

/// Builds one suite scene with its views; the same bits every time. Throws SceneError for an unknown name.
Loaded generate_suite_scene(const std::string& name, int width = 1920, int height = 1080);

}  // namespace zproof
