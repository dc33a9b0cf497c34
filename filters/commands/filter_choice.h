/// A texture filter as typed: NAME, or NAME:key=value:key=value.
#pragma once

#include <string>

#include "filters/study/other_samplers.h"

namespace zproof {

struct FilterChoice {
    std::string typed;
    rasterizer::Texturing texturing;
    const study::OtherSampler* other = nullptr;  ///< null: a method of zproof's own
};

/// Throws UsageError, naming what is known, for an unknown method, key or value, and for samplers of others.
FilterChoice filter_choice(const std::string& word);

/// Accepts samplers of others, too; they take max-anisotropy alone. Otherwise it is as filter_choice().
FilterChoice study_choice(const std::string& word);

/// A line per key with what it takes and does, for --help.
std::string filter_settings_help();

}  // namespace zproof
