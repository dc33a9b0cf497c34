#include "zproof/names.h"

#include <algorithm>

#include "frame/number_text.h"
#include "frame/printable.h"

namespace zproof::api {
namespace {

bool is_of_names(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
}

}  // namespace

void require_name(const std::string& what, const std::string& name) {
    require_no_nul(what, name);
    if (!name.empty() && name.front() != '.' && std::ranges::all_of(name, is_of_names)) return;
    throw InputError{what + ": the name '" + one_line(name) +
                     "' is not usable; expected letters, digits, '-', '_' and '.', which is not the first"};
}

void require_size(const std::string& what, Size size) {
    const auto is_side = [](int side) { return side >= 1 && side <= largest_side; };
    if (is_side(size.width) && is_side(size.height)) return;
    throw InputError{what + ": the size is " + size_text(size.width, size.height) +
                     "; expected 1 to 32768 pixels on either side"};
}

void require_no_nul(const std::string& what, const std::string& text) {
    if (text.find('\0') == std::string::npos) return;
    throw InputError{what + ": the text holds a NUL character"};
}

}  // namespace zproof::api
