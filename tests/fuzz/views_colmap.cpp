// COLMAP's cameras.txt, and behind a 0 its images.txt.
#include "scenes/import/view_import.h"
#include "scenes/scene_error.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto [cameras, images] = split_at_zero(input);
    folder.write("cameras.txt", cameras);
    folder.write("images.txt", images);
    may_refuse<SceneError>([&] { import_colmap(folder.path(), {.near_depth = 0.1, .far_depth = 100}); });
}

}  // namespace zproof::fuzz
