#include <algorithm>

#include "filters/commands/commands.h"
#include "program/nearest_word.h"
#include "program/study_scenes.h"
#include "program/written_scenes.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/scene_error.h"

namespace zproof {

ExitCode execute(const FiltersScenesArguments& arguments) {
    std::vector<std::string> known;
    for (const FilterSceneEntry& entry : filter_scenes()) known.push_back(entry.name);
    const std::vector<std::string>& names = arguments.names.empty() ? known : arguments.names;
    for (const std::string& name : names)
        if (std::ranges::find(known, name) == known.end())
            throw SceneError{name + ": no such filter scene" + did_you_mean(name, known) +
                             " (zproof filters list shows them)"};
    return write_scenes(names, arguments.common, [](const std::string& name) {
        const StudyScene scene{name, {}};
        return load(scene, natural_resolution(scene));
    });
}

}  // namespace zproof
