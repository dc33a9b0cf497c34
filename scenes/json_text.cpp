#include "scenes/json_text.h"

#include <string>

#include "scenes/gltf_limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

/// The position of the quote that closes the string opened at text[open], or the text's end.
std::size_t end_of_string(std::string_view text, std::size_t open) {
    for (std::size_t i = open + 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            return i;
    }
    return text.size();
}

void check_size(const std::filesystem::path& file, std::size_t depth, std::size_t values, std::size_t byte) {
    const std::string place = "byte " + std::to_string(byte);
    if (depth > limits::json_depth)
        refuse(file, place, "nested too deep: at most " + std::to_string(limits::json_depth) + " levels");
    if (values > limits::json_values)
        refuse(file, place, "too many values: at most " + std::to_string(limits::json_values));
}

/// Counts brackets and commas outside strings; malformed text is left to the parser.
void check_extent(const std::filesystem::path& file, std::string_view text) {
    std::size_t depth = 0, values = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') {
            i = end_of_string(text, i);
        } else if (c == '[' || c == '{') {
            check_size(file, ++depth, ++values, i);
        } else if (c == ',') {
            check_size(file, depth, ++values, i);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
}

/// nlohmann's message without its "[json.exception...]" tag.
std::string plain(const std::string& what) {
    const std::size_t tag = what.find("] ");
    return tag == std::string::npos ? what : what.substr(tag + 2);
}

}  // namespace

nlohmann::json parse_json(const std::filesystem::path& file, std::string_view text) {
    check_extent(file, text);
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& error) {
        refuse(file, "JSON", plain(error.what()) + "; mend or export the file again");
    }
}

}  // namespace zproof
