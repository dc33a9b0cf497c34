#include "cli/command_line/tree.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "cli/renderers/registry.h"
#include "cli/report_files.h"
#include "compare/pixel_class.h"
#include "frame/convention_text.h"
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

constexpr std::array meanings{
    NameMeaning{"SCENE", scenes},
    NameMeaning{"--scene", scenes},
    NameMeaning{"NAME", [](const std::string&) { return Candidates{suite_names()}; }},
    NameMeaning{"RENDERER", [](const std::string&) { return Candidates{renderer_names()}; }},
    NameMeaning{"--renderer", [](const std::string&) { return Candidates{renderer_names()}; }},
    NameMeaning{"--oracle",
                [](const std::string&) {
                    return Candidates{with({"none"}, renderer_names()), Paths::none, Listing::by_comma};
                }},
    NameMeaning{"--require",
                [](const std::string&) {
                    return Candidates{renderer_names(), Paths::none, Listing::by_comma};
                }},
    NameMeaning{"--report",
                [](const std::string&) {
                    return Candidates{format_names(), Paths::none, Listing::by_comma};
                }},
    NameMeaning{"--format", [](const std::string&) { return Candidates{format_names()}; }},
    NameMeaning{"--class", [](const std::string&) { return Candidates{class_names()}; }},
    NameMeaning{"--precision", promises},
    NameMeaning{"--reference-precision", promises},
    NameMeaning{"--ids",
                [](const std::string&) {
                    return Candidates{label_words(), Paths::files, Listing::single};
                }},
    NameMeaning{"--sample",
                [](const std::string&) {
                    return Candidates{{"standard:2", "standard:4", "standard:8", "standard:16"}};
                }},
    NameMeaning{"--convention", conventions},
    NameMeaning{"--reference-convention", conventions},
    NameMeaning{"--filter", [](const std::string&) { return Candidates{}; }},
    NameMeaning{"--channels", [](const std::string&) { return Candidates{}; }},
    NameMeaning{"--reference-channels", [](const std::string&) { return Candidates{}; }},
    NameMeaning{"--models",
                [](const std::string&) {
                    return Candidates{{}, Paths::folders};
                }},
    NameMeaning{"--keep-input",
                [](const std::string&) {
                    return Candidates{{}, Paths::folders};
                }},
};

}  // namespace

NameMeanings meanings_of_names() { return meanings; }

}  // namespace zproof
