// What libFuzzer calls for every input that it draws.
#include "tests/fuzz/harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    zproof::fuzz::read_input({data, size});
    return 0;
}
