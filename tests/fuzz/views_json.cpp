// Cameras of NeRF and of OpenCV: the same text to both readers.
#include "scenes/import/view_import.h"
#include "scenes/scene_error.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    constexpr DepthRange range{0.1, 100};
    const auto file = folder.write("input.json", input);
    may_refuse<SceneError>([&] { import_nerf(file, range, {}); });
    may_refuse<SceneError>([&] { import_nerf(file, range, glm::ivec2{64, 48}); });
    may_refuse<SceneError>([&] { import_opencv(file, range); });
}

}  // namespace zproof::fuzz
