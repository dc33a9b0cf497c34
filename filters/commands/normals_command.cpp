#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "filters/commands/commands.h"
#include "filters/normals/normal_study.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/scene_selection.h"
#include "program/study_scenes.h"
#include "program/usage_error.h"
#include "program/work_progress.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

using normals::NormalMap;

/// The plane of checker_plane with the map on it.
Loaded plane_of(const FiltersNormalsArguments& arguments) {
    const auto [width, height] = arguments.resolution;
    if (!arguments.map.empty()) return photograph_scene(arguments.map, width, height);
    return plane_scene("bumps", normals::image_of(normals::bumps()), width, height);
}

NormalMap map_of(const Loaded& loaded) try {
    return normals::normal_map(loaded.scene.images.at(0));
} catch (const std::runtime_error& e) {
    throw SceneError{loaded.scene.name + ": " + e.what()};
}

int width_of(const normals::HighlightScore& score) {
    return int(std::max<std::size_t>(score.model.size(), 6)) + 2;
}

std::string line_of(const std::string& method, const std::vector<normals::HighlightScore>& scores) {
    std::ostringstream line;
    line << "  " << std::left << std::setw(24) << method << std::right << std::fixed << std::setprecision(4);
    for (const normals::HighlightScore& score : scores) line << std::setw(width_of(score)) << score.rmse;
    return line.str() + "\n";
}

std::string heading_of(const std::string& view, const std::vector<normals::HighlightScore>& scores) {
    std::ostringstream line;
    line << std::left << std::setw(26) << view << std::right;
    for (const normals::HighlightScore& score : scores) line << std::setw(width_of(score)) << score.model;
    return line.str() + "\n";
}

}  // namespace

ExitCode execute(const FiltersNormalsArguments& arguments) {
    const Loaded loaded = plane_of(arguments);
    const NormalMap map = map_of(loaded);
    const std::vector<View> views = chosen_views(loaded, arguments.views);
    note_interrupts();
    const std::size_t all = views.size() * arguments.methods.size();
    std::size_t done = 0;
    WorkProgress progress{std::cerr, progress_beside_lines(arguments.common), double(all)};
    on_threads(arguments.common.threads, [&] {
        for (const View& view : views)
            for (const FilterChoice& choice : arguments.methods) {
                if (interrupted()) return;
                progress.begin(view.name + ": " + choice.typed + ": ");
                const auto scores =
                    normals::highlight_scores(loaded.scene, view, map, arguments.light, choice.texturing);
                const bool is_first = &choice == &arguments.methods.front();
                progress.say(std::cout,
                             (is_first ? heading_of(view.name, scores) : "") + line_of(choice.typed, scores));
                ++done;
            }
    });
    if (done < all) return say_interrupted({done, all}, "filter", "scored");
    return ExitCode::proven;
}

}  // namespace zproof
