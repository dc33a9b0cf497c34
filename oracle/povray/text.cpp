#include "oracle/povray/text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace zproof::oracle {

std::string number_text(double number) {
    assert(std::isfinite(number));
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

std::string vector_text(const glm::dvec3& v) {
    std::string text = "<";
    text.append(number_text(v.x)).append(",");
    text.append(number_text(v.y)).append(",");
    return text.append(number_text(v.z)).append(">");
}

}  // namespace zproof::oracle
