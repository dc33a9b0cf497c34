/// Conventions as they are typed and as JSON (docs/conventions.md).
#pragma once

#include <string>
#include <vector>

#include "frame/convention.h"

namespace zproof {

/// What --convention and --channels were given; either may be empty. `convention` is the name of a preset,
/// the same with changes, "bop,depth_scale=0.1", changes alone, or a JSON file; `channels` is
/// "id=NAME,depth=NAME" or one of the two. Throws FrameError where a word, file or key is not understood.
Convention convention_from_words(const std::string& convention, const std::string& channels);

/// Whether --convention was given a file.
bool is_convention_file(const std::string& word);

/// The names of the presets.
std::vector<std::string> convention_names();

}  // namespace zproof
