#include <algorithm>

#include "cli/commands.h"
#include "cli/filters/scenes.h"
#include "cli/nearest_word.h"
#include "cli/written_scenes.h"
#include "filters/scenes/filter_scenes.h"
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
