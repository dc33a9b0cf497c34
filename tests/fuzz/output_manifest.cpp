// The list that zproof keeps of what it wrote into a folder.
#include "reports/output_manifest.h"

#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    folder.write(output_marker, input);
    manifest_in(folder.path());
}

}  // namespace zproof::fuzz
