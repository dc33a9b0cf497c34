#include "cli/result_line.h"

namespace zproof {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n') + 1); }

std::string last_line(const std::string& text) {
    const std::size_t end = text.rfind('\n', text.size() - 2);  // of the line before
    return end == std::string::npos ? text : text.substr(end + 1);
}

}  // namespace zproof
