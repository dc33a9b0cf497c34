// planes.zvp, and what its blocks hold: as many numbers as the input's first byte says.
#include "reports/planes/coding.h"
#include "reports/planes/container.h"
#include "tests/fuzz/harness.h"

namespace zproof::fuzz {
namespace {

using namespace planes;

void read_block(const std::string& content, std::size_t count) {
    const std::vector<std::uint32_t> guess(count, 7);
    may_refuse<ReportError>(
        [&] { decode(content, count, std::max<std::size_t>(count / 2, 1), Prediction::planar); });
    may_refuse<ReportError>([&] { decode(content, guess); });
    may_refuse<ReportError>([&] { decode_sparse(content, count / 2, guess); });
    may_refuse<ReportError>([&] { decode_doubles(content, count); });
}

}  // namespace

void read_input(Input input) {
    if (input.empty()) return;
    const std::string text = text_of(input.subspan(1));
    may_refuse<ReportError>([&] {
        const Container container = unpacked(text, "input");
        const std::string again = packed(container);
        require(packed(unpacked(again, "again")) == again, "a written container is read back");
        for (const Block& block : container.blocks) read_block(block.content, input[0]);
    });
}

}  // namespace zproof::fuzz
