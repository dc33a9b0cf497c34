#include "reports/result_file.h"

#include "frame/frame_error.h"
#include "frame/input_file.h"

namespace zproof {

std::string read_result(const std::filesystem::path& file, const std::string& expected) try {
    return read_input(file, {.words = expected, .most_bytes = largest_result_bytes});
} catch (const FrameError& e) {
    throw ReportError(e.what());
}

std::string json_fault(const std::exception& of_the_parser) {
    const std::string what = of_the_parser.what();
    const std::size_t tag = what.find("] ");  // behind "[json.exception.parse_error.101"
    return (tag == std::string::npos ? what : what.substr(tag + 2)) +
           "; expected what zproof wrote: run it again";
}

}  // namespace zproof
