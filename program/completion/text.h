/// Pieces of text that the scripts have in common.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/joined.h"
#include "program/command_line/outline.h"

namespace zproof {

std::string replaced(std::string text, const std::string& from, const std::string& to);

/// Calls `visit` for the root and every command below it, parents first.
void for_each_command(const OutlineCommand& root, const std::function<void(const OutlineCommand&)>& visit);

}  // namespace zproof
