/// Where a report goes: a file, a stream or a text. One of many views is never in memory whole.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace zproof {

/// Takes the report piece by piece, in its order.
using TextSink = std::function<void(std::string_view)>;

/// All that `write` puts out, in memory.
inline std::string collected(const std::function<void(const TextSink&)>& write) {
    std::string text;
    write([&](std::string_view piece) { text += piece; });
    return text;
}

}  // namespace zproof
