/// Words and sizes that callers choose.
#pragma once

#include <string>

#include "zproof/zproof.h"

namespace zproof::api {

/// Throws InputError where a name is not of letters, digits, '-', '_' and '.', or begins with '.': it becomes
/// a file's. `what`: "view".
void require_name(const std::string& what, const std::string& name);

/// Throws InputError where a side is not of 1 to largest_side pixels.
void require_size(const std::string& what, Size size);

/// Throws InputError where a text holds a NUL character, at which C's functions would end it.
void require_no_nul(const std::string& what, const std::string& text);

}  // namespace zproof::api
