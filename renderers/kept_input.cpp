#include "renderers/kept_input.h"

#include <system_error>
#include <utility>

#include "frame/frame_error.h"
#include "frame/whole_file.h"
#include "program/samples.h"
#include "scenes/glb_writer.h"
#include "scenes/view_document.h"

namespace zproof {

KeptInput::KeptInput(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::string KeptInput::keep(const Scene& scene) {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error)
        throw FrameError{folder_.string() + ": cannot be made: " + error.message() +
                         "; expected a folder, or a place for one (--keep-input)"};
    std::string name = scenes_.next(scene.name.empty() ? "scene" : scene.name);
    write_glb_file(folder_ / (name + ".glb"), scene);
    return name;
}

void KeptInput::keep(const std::string& scene, const View& view) {
    write_whole_file(folder_ / (cameras_.next(scene, shown_name(view)) + ".camera.json"),
                     camera_document(view));
}

}  // namespace zproof
