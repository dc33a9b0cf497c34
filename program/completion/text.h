/// Pieces of text that the scripts have in common.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/joined.h"
#include "program/command_line/outline.h"

namespace zproof {

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// Calls `visit` for the root and every command below it, parents first.
inline void for_each_command(const OutlineCommand& root,
                             const std::function<void(const OutlineCommand&)>& visit) {
    visit(root);
    for (const OutlineCommand& command : root.commands) for_each_command(command, visit);
}

}  // namespace zproof
