#include "cli/completion/candidates.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "cli/renderers/registry.h"
#include "cli/report_files.h"
#include "compare/pixel_class.h"
#include "filters/conformance/filter_precision_presets.h"
#include "filters/methods/catalogue.h"
#include "filters/scenes/filter_scenes.h"
#include "filters/study/regions.h"
#include "frame/convention_text.h"
#include "math/processor.h"
#include "scenes/suite.h"
#include "scenes/triangle_labels.h"

namespace zproof {
namespace {

using Words = std::vector<std::string>;

Words suite_names() {
    Words names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    for (const SuiteEntry& entry : thorough_manifest()) names.push_back(entry.name);
    return names;
}

Words filter_scene_names() {
    Words names;
    for (const FilterSceneEntry& entry : filter_scenes()) names.push_back(entry.name);
    return names;
}

Words method_names() {
    Words names;
    for (const texture::Method& method : texture::methods()) names.push_back(method.name);
    return names;
}

Words filter_preset_names() {
    Words names;
    for (const FilterPrecisionPreset& preset : filter_precision_presets()) names.emplace_back(preset.name);
    return names;
}

Words region_names() {
    Words names;
    for (const study::RegionCard& card : study::region_cards())
        if (card.name.find(' ') == std::string::npos) names.push_back(card.name);
    return names;
}

Words class_names() {
    Words names;
    for (int c = 0; c < pixel_class_count; ++c) names.emplace_back(name_of(PixelClass(c)));
    return names;
}

Words format_names() {
    Words names;
    for (const ReportFormat format : all_formats()) names.push_back(name_of(format));
    return names;
}

Words isa_names() {
    Words names;
    for (const InstructionSet set : {InstructionSet::scalar, InstructionSet::avx2, InstructionSet::avx512})
        names.emplace_back(name_of(set));
    return names;
}

Words with(Words words, const Words& more) {
    std::ranges::copy(more, std::back_inserter(words));
    return words;
}

Candidates scenes(const OutlineCommand& command) {
    if (command.path.starts_with("filters"))
        return {with(filter_scene_names(), suite_names()), Paths::files, Listing::single};
    if (command.path == "run" || command.path == "fit" || command.path == "selfcheck")
        return {with({"suite"}, suite_names()), Paths::files, Listing::single};
    return {suite_names(), Paths::files, Listing::single};
}

Candidates promises(const OutlineCommand& command) {
    if (command.path.starts_with("filters")) return {filter_preset_names()};
    return {{"raster", "ray", "plane_ray"}, Paths::files, Listing::single};
}

Candidates conventions(const OutlineCommand&) { return {convention_names(), Paths::files, Listing::single}; }

/// One name that stands for the same wherever it occurs.
struct Meaning {
    const char* name;
    Candidates (*candidates)(const OutlineCommand& command);
};

constexpr std::array meanings{
    Meaning{"SCENE", scenes},
    Meaning{"--scene", scenes},
    Meaning{"NAME", [](const OutlineCommand&) { return Candidates{suite_names()}; }},
    Meaning{"RENDERER", [](const OutlineCommand&) { return Candidates{renderer_names()}; }},
    Meaning{"--renderer", [](const OutlineCommand&) { return Candidates{renderer_names()}; }},
    Meaning{"--oracle",
            [](const OutlineCommand&) {
                return Candidates{with({"none"}, renderer_names()), Paths::none, Listing::by_comma};
            }},
    Meaning{"--require",
            [](const OutlineCommand&) {
                return Candidates{renderer_names(), Paths::none, Listing::by_comma};
            }},
    Meaning{"--report",
            [](const OutlineCommand&) {
                return Candidates{format_names(), Paths::none, Listing::by_comma};
            }},
    Meaning{"--format", [](const OutlineCommand&) { return Candidates{format_names()}; }},
    Meaning{"--filter", [](const OutlineCommand&) { return Candidates{method_names()}; }},
    Meaning{"--methods",
            [](const OutlineCommand&) {
                return Candidates{with({"all"}, method_names()), Paths::none, Listing::by_comma};
            }},
    Meaning{"METHODS",
            [](const OutlineCommand&) {
                return Candidates{with({"all"}, method_names()), Paths::none, Listing::by_comma};
            }},
    Meaning{"--isa", [](const OutlineCommand&) { return Candidates{isa_names()}; }},
    Meaning{"--region", [](const OutlineCommand&) { return Candidates{region_names()}; }},
    Meaning{"--class", [](const OutlineCommand&) { return Candidates{class_names()}; }},
    Meaning{"--precision", promises},
    Meaning{"--reference-precision", promises},
    Meaning{"--ids",
            [](const OutlineCommand&) {
                return Candidates{label_words(), Paths::files, Listing::single};
            }},
    Meaning{"--sample",
            [](const OutlineCommand&) {
                return Candidates{{"standard:2", "standard:4", "standard:8", "standard:16"}};
            }},
    Meaning{"--convention", conventions},
    Meaning{"--reference-convention", conventions},
    Meaning{"--channels", [](const OutlineCommand&) { return Candidates{}; }},
    Meaning{"--reference-channels", [](const OutlineCommand&) { return Candidates{}; }},
    Meaning{"--models",
            [](const OutlineCommand&) {
                return Candidates{{}, Paths::folders};
            }},
    Meaning{"--keep-input",
            [](const OutlineCommand&) {
                return Candidates{{}, Paths::folders};
            }},
    Meaning{"DIR",
            [](const OutlineCommand&) {
                return Candidates{{}, Paths::folders};
            }},
    Meaning{"--view", [](const OutlineCommand&) { return Candidates{}; }},
    Meaning{"--pixel", [](const OutlineCommand&) { return Candidates{}; }},
    Meaning{"--crop", [](const OutlineCommand&) { return Candidates{}; }},
};

bool is_number(const std::string& kind) {
    return std::ranges::any_of(std::array{"INT", "UINT", "FLOAT"},
                               [&](const char* number) { return kind.starts_with(number); });
}

}  // namespace

Candidates candidates_for(const OutlineCommand& command, const OutlineOption& option) {
    if (!option.choices.empty()) return {option.choices};
    for (const std::string& name : option.names) {
        const auto meaning = std::ranges::find_if(meanings, [&](const Meaning& m) { return m.name == name; });
        if (meaning != meanings.end()) return meaning->candidates(command);
    }
    if (option.kind == "FOLDER") return {{}, Paths::folders};
    return {{}, is_number(option.kind) ? Paths::none : Paths::files};
}

}  // namespace zproof
