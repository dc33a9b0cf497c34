#include <algorithm>
#include <iostream>

#include "filters/commands/commands.h"
#include "filters/methods/catalogue.h"
#include "filters/metrics/picture_metric.h"
#include "filters/study/other_samplers.h"
#include "scenes/filters/filter_scenes.h"

namespace zproof {
namespace {

struct Line {
    std::string name, words;
};

void print(const std::string& title, const std::vector<Line>& lines) {
    std::size_t width = 0;
    for (const Line& line : lines) width = std::max(width, line.name.size());
    std::cout << title << "\n";
    for (const Line& line : lines)
        std::cout << "  " << line.name << std::string(width - line.name.size() + 2, ' ') << line.words
                  << "\n";
}

}  // namespace

ExitCode execute(const FiltersListArguments&) {
    std::vector<Line> methods, metrics, scenes;
    for (const texture::Method& method : texture::methods())
        methods.push_back({method.name, method.card.taps});
    for (const study::OtherSampler& other : study::other_samplers())
        methods.push_back({other.method.name, other.method.card.taps});
    for (const PictureMetric& metric : picture_metrics(LightRange::beyond_white))
        metrics.push_back({std::string{metric.name}, std::string{metric.definition}});
    for (const FilterSceneEntry& scene : filter_scenes()) scenes.push_back({scene.name, scene.reason});
    print("methods (docs/texture-filters.md)", methods);
    print("\nmetrics (docs/filters.md)", metrics);
    print("\nscenes", scenes);
    return ExitCode::proven;
}

}  // namespace zproof
