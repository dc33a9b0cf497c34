/// Turns words of the command line into the scenes of a study.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/plane.h"
#include "program/common_arguments.h"
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

/// The size that was asked for, or the scene's natural one. Where its views state another one themselves, a
/// line on stderr says so, unless the command is quiet. Throws SceneError.
struct AskedSize {
    std::optional<int> width, height;
};
Loaded load(const StudyScene& scene, const AskedSize& asked, const CommonArguments& common);

/// Those of its views that were asked for, all where none is named. Throws UsageError where it has none of
/// them.
std::vector<View> chosen_views(const Loaded& loaded, const std::vector<std::string>& requested);

/// The size at which a scene is studied where nobody says: 512 x 512; of the worked set-up its own, 256 x
/// 256.
Resolution natural_resolution(const StudyScene& scene);

/// The first row that counts where nobody says: of the worked set-up the 56th of 256, else 0.
int natural_first_row(const StudyScene& scene, int height);

}  // namespace zproof
