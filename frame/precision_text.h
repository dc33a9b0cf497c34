/// Declared precision as JSON, for renderers that are programs or files (docs/renderer-contract.md).
#pragma once

#include <filesystem>
#include <string>

#include "frame/precision.h"

namespace zproof {

/// Reads {"kind": "raster", "transform": "float32", "subpixel_bits": 8, ...} or another kind, or a preset's
/// name for the kind. A key that is left out has its default (docs/renderer-contract.md); one that is
/// unknown, of another type or out of range is refused. `place` is what errors call the text. Throws
/// FrameError.
Precision precision_from_json(const std::string& text, const std::string& place);

/// What --precision was given: a JSON file, or the same in one word, "raster,subpixel_bits=4,snap=truncate"
/// or "opengl". Throws FrameError where the file cannot be read or the word not understood.
Precision precision_from_word(const std::string& word);

/// Whether --precision was given a word; any other text names a file.
bool is_promise_in_words(const std::string& word);

/// The projections that the same declaration says the renderer has: all, unless it lists them.
Projections projections_from_word(const std::string& word);

/// All keys, one line; precision_from_json gives it back.
std::string precision_to_json(const Precision& precision);

}  // namespace zproof
