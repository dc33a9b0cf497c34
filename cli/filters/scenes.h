/// From words to the scenes of a study.
#pragma once

#include <string>
#include <vector>

#include "frame/plane.h"
#include "scenes/loaded.h"

namespace zproof {

/// A scene that is known of, not yet loaded.
struct StudyScene {
    std::string word;
    std::string reason;  ///< empty for what is not a built-in filter scene
};

/// Every built-in filter scene where no word is given; else filter scenes, suite scenes and files. Throws
/// UsageError for a word that is none of this.
std::vector<StudyScene> study_scenes(const std::vector<std::string>& words);

/// Throws SceneError.
Loaded load(const StudyScene& scene, Resolution resolution);

}  // namespace zproof
