// A file of labels for the triangles of a scene that has twelve.
#include "scenes/scene_error.h"
#include "scenes/triangle_labels.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto file = folder.write("input.json", input);
    may_refuse<SceneError>(
        [&] { require(read_label_file(file, 12).size() == 12, "every triangle has a label"); });
}

}  // namespace zproof::fuzz
