// A convention: a file, or the words of --convention, and behind a 0 the words of --channels.
#include "frame/convention_text.h"
#include "frame/frame_error.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

void read_input(Input input) {
    static const ScratchFolder folder;
    const auto words = split_at_zero(input);
    const auto file = folder.write("input.json", words.first);
    may_refuse<FrameError>([&] { convention_from_words(text_of(words.first), text_of(words.second)); });
    may_refuse<FrameError>([&] { convention_from_words(file.string(), ""); });
}

}  // namespace zproof::fuzz
