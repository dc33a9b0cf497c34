#include "program/failure.h"

#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>

#include "frame/printable.h"
#include "math/processor.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

ExitCode complain(std::string_view kind, const std::exception& e, ExitCode code) {
    const std::string line = "zproof: " + std::string{kind} + ": " + e.what();
    std::cerr << shortened(line, longest_line_bytes - 2) << "\n";
    return code;
}

}  // namespace

ExitCode report_failures(const std::string_view& refusal, const std::function<ExitCode()>& work) {
    try {
        return work();
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

}  // namespace zproof
