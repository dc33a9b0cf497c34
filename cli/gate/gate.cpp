#include "cli/gate/gate.h"

#include "cli/waivers/waiver_file.h"

namespace zproof {

Gate open_gate(const GateArguments& arguments) {
    Gate gate{
        .waivers = {}, .today = arguments.today.value_or(this_day()), .strictness = arguments.strictness};
    if (!arguments.waivers.empty()) gate.waivers = read_waivers(arguments.waivers);
    return gate;
}

Day this_day() { return Day{std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now())}; }

}  // namespace zproof
