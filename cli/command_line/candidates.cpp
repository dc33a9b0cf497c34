#include "cli/command_line/tree.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "cli/report_files.h"
#include "frame/convention_text.h"
#include "renderers/registry.h"
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

Words format_names() {
    Words names;
    for (const ReportFormat format : all_formats()) names.push_back(name_of(format));
    return names;
}

Words with(Words words, const Words& more) {
    std::ranges::copy(more, std::back_inserter(words));
    return words;
}

Candidates scenes(const std::string& path) {
    if (path == "run" || path == "fit" || path == "selfcheck")
        return {with({"suite"}, suite_names()), Paths::files, Listing::single};
    return {suite_names(), Paths::files, Listing::single};
}

Candidates promises(const std::string&) {
    return {{"raster", "ray", "plane_ray"}, Paths::files, Listing::single};
}

Candidates conventions(const std::string&) { return {convention_names(), Paths::files, Listing::single}; }

/// Several of the words may be typed, with commas between them.
Candidates several(Words words) { return {std::move(words), Paths::none, Listing::by_comma}; }

constexpr std::array kinds{
    ValueKind{"SCENE", scenes},
    ValueKind{"NAME", [](const std::string&) { return Candidates{suite_names()}; }},
    ValueKind{"RENDERER", [](const std::string&) { return Candidates{renderer_names()}; }},
    ValueKind{"RENDERERS", [](const std::string&) { return several(renderer_names()); }},
    ValueKind{"ORACLES", [](const std::string&) { return several(with({"none"}, renderer_names())); }},
    ValueKind{"FORMAT", [](const std::string&) { return Candidates{format_names()}; }},
    ValueKind{"FORMATS", [](const std::string&) { return several(format_names()); }},
    ValueKind{"PROMISE", promises},
    ValueKind{"IDS",
              [](const std::string&) {
                  return Candidates{label_words(), Paths::files};
              }},
    ValueKind{"CONVENTION", conventions},
    ValueKind{"SAMPLE",
              [](const std::string&) {
                  return Candidates{{"standard:2", "standard:4", "standard:8", "standard:16"}};
              }},
};

}  // namespace

ValueKinds value_kinds() { return kinds; }

}  // namespace zproof
