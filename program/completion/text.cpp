#include "program/completion/text.h"

namespace zproof {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

void for_each_command(const OutlineCommand& root, const std::function<void(const OutlineCommand&)>& visit) {
    visit(root);
    for (const OutlineCommand& command : root.commands) for_each_command(command, visit);
}

}  // namespace zproof
