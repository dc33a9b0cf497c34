// A candidate's frame as OpenEXR, TIFF, PNG or PFM. The input's first byte chooses the convention.
#include <cstring>

#include "tests/fuzz/candidate_frame.h"

namespace zproof::fuzz {
namespace {

/// Has an OpenEXR file's first header an attribute that is longer than the rest of the file? OpenEXR fills as
/// much memory before it reads it: a tenth of a second and up to 2 GB.
bool claims_more_than_it_has(Input file) {
    constexpr std::string_view magic = "\x76\x2f\x31\x01";
    if (file.size() < 8 || !text_of(file).starts_with(magic)) return false;
    for (Input rest = file.subspan(8); !rest.empty() && rest[0] != 0;) {
        const Input type = split_at_zero(rest).second;
        rest = split_at_zero(type).second;
        std::uint32_t size = 0;
        if (rest.size() < sizeof size) return false;
        std::memcpy(&size, rest.data(), sizeof size);
        rest = rest.subspan(sizeof size);
        if (size > rest.size()) return true;
        rest = rest.subspan(size);
    }
    return false;
}

}  // namespace

void read_input(Input input) {
    static const ScratchFolder folder;
    if (input.empty() || claims_more_than_it_has(input.subspan(1))) return;
    const auto file = folder.write("input.image", input.subspan(1));
    may_refuse<FrameError>([&] { read_candidate_frame(file, convention_numbered(input[0])); });
}

}  // namespace zproof::fuzz
