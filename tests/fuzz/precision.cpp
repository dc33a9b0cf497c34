// A declared precision: JSON, or the words of --precision.
#include "frame/frame_error.h"
#include "frame/precision_text.h"
#include "tests/fuzz/harness.h"

namespace zproof::fuzz {
namespace {

void require_same_again(const Precision& precision) {
    const std::string text = precision_to_json(precision);
    require(precision_to_json(precision_from_json(text, "again")) == text,
            "a written precision is read back");
}

}  // namespace

void read_input(Input input) {
    const std::string text = text_of(input);
    may_refuse<FrameError>([&] { require_same_again(precision_from_json(text, "input")); });
    may_refuse<FrameError>([&] { require_same_again(precision_from_word(text)); });
    may_refuse<FrameError>([&] { projections_from_word(text); });
}

}  // namespace zproof::fuzz
