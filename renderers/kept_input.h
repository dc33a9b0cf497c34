/// What a program under test is handed, kept as files (--keep-input).
#pragma once

#include <filesystem>
#include <string>

#include "program/folder_names.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

class KeptInput {
  public:
    /// The folder is made when there is something to keep. Files in it that have the same names are replaced.
    explicit KeptInput(std::filesystem::path folder);

    /// Writes SCENE.glb and returns SCENE: the scene's name, made safe, with "-2", "-3", ... where another
    /// scene has it. Throws FrameError or SceneError where it cannot write.
    std::string keep(const Scene& scene);

    /// Writes SCENE-VIEW.camera.json, with "-2", "-3", ... where another view has that name. Throws
    /// FrameError.
    void keep(const std::string& scene, const View& view);

  private:
    std::filesystem::path folder_;
    FolderNames scenes_, cameras_;
};

}  // namespace zproof
