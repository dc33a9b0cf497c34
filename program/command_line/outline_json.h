/// An outline on its way from one program to another.
#pragma once

#include <string>

#include "program/command_line/outline.h"

namespace zproof {

std::string json_of(const OutlineCommand& outline);

/// Throws std::runtime_error where the text is none.
OutlineCommand outline_from(const std::string& json);

}  // namespace zproof
