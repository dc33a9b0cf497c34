#include "reports/text_sink.h"

namespace zproof {

std::string collected(const std::function<void(const TextSink&)>& write) {
    std::string text;
    write([&](std::string_view piece) { text += piece; });
    return text;
}

}  // namespace zproof
