#include "program/run_program.h"

#include <malloc.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include "program/failure.h"
#include "program/interrupt.h"
#include "program/printed_file.h"

namespace zproof {
namespace {

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

int run_program(int argc, const char* const* argv, ParseCommandLine parse) {
    keep_freed_memory();
    fail_writes_on(SIGXFSZ);
    std::string_view refusal = "cannot read the settings";
    return int(report_failures(refusal, [&] {
        const Command command =
            parse(argc, argv, [](const std::string& name) { return std::getenv(name.c_str()); });
        refusal = command.refusal;
        PrintedFile printed{command.common};
        const ExitCode code = command.execute();
        printed.finish();
        return code;
    }));
}

}  // namespace zproof
