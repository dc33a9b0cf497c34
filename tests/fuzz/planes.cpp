// planes.zvp
#include "reports/planes/container.h"
#include "tests/fuzz/harness.h"

namespace zproof::fuzz {

using namespace planes;

void read_input(Input input) {
    const std::string text = text_of(input);
    may_refuse<ReportError>([&] {
        const Container container = unpacked(text, "input");
        const std::string again = packed(container);
        require(packed(unpacked(again, "again")) == again, "a written container is read back");
    });
}

}  // namespace zproof::fuzz
