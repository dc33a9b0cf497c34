#include "program/command_line/examples.h"

namespace zproof {

std::string in_words(Examples examples, std::string_view command) {
    constexpr std::size_t column = 40;
    std::string text;
    for (const Example& example : examples) {
        if (example.command != command) continue;
        std::string line = "  " + std::string{example.line};
        if (line.size() + 2 > column) line += "\n";
        const std::size_t used = line.back() == '\n' ? 0 : line.size();
        text += line + std::string(column - used, ' ') + std::string{example.meaning} + "\n";
    }
    return text;
}

}  // namespace zproof
