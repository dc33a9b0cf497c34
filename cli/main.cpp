#include <malloc.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/printed_file.h"
#include "cli/refusal.h"
#include "cli/usage_error.h"
#include "frame/printable.h"
#include "math/processor.h"

namespace zproof {
namespace {

ExitCode complain(std::string_view kind, const std::exception& e, ExitCode code) {
    const std::string line = "zproof: " + std::string{kind} + ": " + e.what();
    std::cerr << shortened(line, longest_line_bytes - 2) << "\n";
    return code;
}

/// The one place where errors meet. A failing pixel is a result and is not among them.
ExitCode guarded_run(int argc, const char* const* argv) {
    std::string_view refusal = "cannot read the settings";
    try {
        const Command command =
            parse_command_line(argc, argv, [](const std::string& name) { return std::getenv(name.c_str()); });
        refusal = refusal_of(command);
        PrintedFile printed{common_of(command)};
        const ExitCode code = std::visit([](const auto& arguments) { return execute(arguments); }, command);
        printed.finish();
        return code;
    } catch (const UsageError& e) {
        return complain("usage", e, ExitCode::usage);
    } catch (const InstructionSetError& e) {  // ZPROOF_ISA, of a command without --isa
        return complain("usage", e, ExitCode::usage);
    } catch (const std::runtime_error& e) {  // the world refused: nothing is said about the renderer
        return complain(refusal, e, ExitCode::cannot_judge);
    } catch (const std::bad_alloc&) {
        return complain(refusal,
                        std::runtime_error{"out of memory; make the picture or the scene smaller, free "
                                           "memory, or raise the limit (ulimit -v)"},
                        ExitCode::cannot_judge);
    } catch (const std::exception& e) {  // logic_error: our own fault
        return complain("internal error", e, ExitCode::internal);
    }
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
    return int(zproof::guarded_run(argc, argv));
}
