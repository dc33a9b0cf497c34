/// Keys that stand twice in an object of a JSON text: RFC 8259 leaves open which counts, and readers differ.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace zproof {

struct RepeatedKey {
    std::size_t byte = 0;  ///< of the text, at which the key stands again
    std::string why = {};  ///< "\"meshes\" stands twice in its object; expected each key once"
};

/// Of text that is not JSON it may find none.
std::optional<RepeatedKey> repeated_key(std::string_view json);

/// Throws FrameError, naming place and byte, where a key stands twice.
void refuse_repeated_key(std::string_view json, const std::string& place);

}  // namespace zproof
