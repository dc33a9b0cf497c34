#include <algorithm>
#include <array>
#include <iterator>

#include "filters/commands/command_line.h"
#include "filters/conformance/filter_precision_presets.h"
#include "filters/methods/catalogue.h"
#include "filters/study/regions.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/suite.h"

namespace zproof::filters_program {
namespace {

using Words = std::vector<std::string>;

Candidates scenes(const std::string&) {
    Words names;
    for (const FilterSceneEntry& entry : filter_scenes()) names.push_back(entry.name);
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    for (const SuiteEntry& entry : thorough_manifest()) names.push_back(entry.name);
    return {names, Paths::files, Listing::single};
}

Candidates scene_names(const std::string&) {
    Candidates candidates;
    for (const FilterSceneEntry& entry : filter_scenes()) candidates.words.push_back(entry.name);
    return candidates;
}

Candidates methods(const std::string&) {
    Words names{"all"};
    for (const texture::Method& method : texture::methods()) names.push_back(method.name);
    return {names, Paths::none, Listing::by_comma};
}

Candidates presets(const std::string&) {
    Candidates candidates;
    for (const FilterPrecisionPreset& preset : filter_precision_presets())
        candidates.words.emplace_back(preset.name);
    return candidates;
}

Candidates regions(const std::string&) {
    Candidates candidates;
    for (const study::RegionCard& card : study::region_cards())
        if (card.name.find(' ') == std::string::npos) candidates.words.push_back(card.name);
    return candidates;
}

constexpr std::array kinds{ValueKind{"SCENE", scenes}, ValueKind{"NAME", scene_names},
                           ValueKind{"METHODS", methods}, ValueKind{"REGION", regions},
                           ValueKind{"PROMISE", presets}};

}  // namespace

ValueKinds value_kinds() { return kinds; }

}  // namespace zproof::filters_program
