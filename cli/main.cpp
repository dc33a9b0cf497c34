#include <malloc.h>

#include <csignal>
#include <cstdlib>
#include <string>
#include <string_view>

#include "cli/commands.h"
#include "cli/guarded.h"
#include "cli/interrupt.h"
#include "cli/printed_file.h"
#include "cli/refusal.h"

namespace zproof {
namespace {

ExitCode run_command_line(int argc, const char* const* argv) {
    std::string_view refusal = "cannot read the settings";
    return guarded(refusal, [&] {
        const Command command =
            parse_command_line(argc, argv, [](const std::string& name) { return std::getenv(name.c_str()); });
        refusal = refusal_of(command);
        PrintedFile printed{common_of(command)};
        const ExitCode code = std::visit([](const auto& arguments) { return execute(arguments); }, command);
        printed.finish();
        return code;
    });
}

/// What was touched once is used again: coming by a page takes longer than filling it, and reports are made
/// in buffers of some megabytes, each of which would be the system's again as soon as it is written. Between
/// scenes it is given back (cli/worker.cpp).
void keep_freed_memory() {
    constexpr int largest_buffer_bytes = 32 << 20;  // the most that glibc looks for among what was freed
    constexpr int most_kept_bytes = 1 << 30;
    mallopt(M_MMAP_THRESHOLD, largest_buffer_bytes);
    mallopt(M_TRIM_THRESHOLD, most_kept_bytes);
}

}  // namespace
}  // namespace zproof

int main(int argc, char** argv) {
    zproof::keep_freed_memory();
    zproof::fail_writes_on(SIGXFSZ);
    return int(zproof::run_command_line(argc, argv));
}
