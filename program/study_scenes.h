/// Turns words of the command line into the scenes of a study.
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

/// Those of its views that were asked for, all where none is named. Throws UsageError where it has none of
/// them.
std::vector<View> chosen_views(const Loaded& loaded, const std::vector<std::string>& requested);

/// The size at which a scene is studied where nobody says: 512 x 512; of the worked set-up its own, 256 x
/// 256.
Resolution natural_resolution(const StudyScene& scene);

/// The first row that counts where nobody says: of the worked set-up the 56th of 256, else 0.
int natural_first_row(const StudyScene& scene, int height);

}  // namespace zproof
