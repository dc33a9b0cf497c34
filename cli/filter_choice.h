/// A texture filter as typed: NAME, or NAME:key=value:key=value.
#pragma once

#include <string>

#include "rasterizer/texturing.h"

namespace zproof {

struct FilterChoice {
    std::string typed;
    rasterizer::Texturing texturing;
};

/// Throws UsageError, naming what is known, for an unknown method, key or value.
FilterChoice filter_choice(const std::string& word);

/// A line per key with what it takes and does, for --help.
std::string filter_settings_help();

}  // namespace zproof
