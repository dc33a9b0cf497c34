// A .gltf, or a .glb where the bytes begin as one: loaded, baked, and held to the ranges that are judged.
#include "scenes/gltf/gltf.h"

#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"
#include "tests/fuzz/image_module.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto file = folder.write("input.gltf", input);
    Loaded loaded;
    may_refuse<SceneError>([&] { loaded = load_gltf(file, 64, 48); });
    may_refuse<SceneError>([&] { require_judged(loaded.scene); });
    for (const View& view : loaded.views) may_refuse<SceneError>([&] { require_judged(view); });
}

}  // namespace zproof::fuzz
