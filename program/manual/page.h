/// The manual page zproof(1), written from the command line's own tree.
#pragma once

#include <string>

#include "program/command_line/outline.h"

namespace zproof {

/// The page in the roff of man(7), which `man` and groff read without a warning.
std::string manual_page(const OutlineCommand& root);

}  // namespace zproof
