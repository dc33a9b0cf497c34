// A candidate's frame as OpenEXR, TIFF, PNG or PFM. The input's first byte chooses the convention.
#include "tests/fuzz/candidate_frame.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    if (input.empty()) return;
    const auto file = folder.write("input.image", input.subspan(1));
    may_refuse<FrameError>([&] { read_candidate_frame(file, convention_numbered(input[0])); });
}

}  // namespace zproof::fuzz
