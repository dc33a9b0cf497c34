#include "cli/run_size.h"

#include <array>

#include "program/settings.h"

namespace zproof {
namespace {

constexpr Resolution quick_resolution{480, 270};

/// Odd, higher than wide, no multiple of a block or a tile, one row, one column, one pixel.
constexpr std::array<Resolution, 5> further_resolutions{{{641, 359}, {37, 101}, {257, 1}, {1, 131}, {1, 1}}};

SceneSource at(const SceneSource& source, const Resolution& size) {
    SceneSource one = source;
    one.suite_name = source.name;
    one.name += "." + std::to_string(size.width) + "x" + std::to_string(size.height);
    one.size = size;
    return one;
}

}  // namespace

Resolution resolution_for(RunSize size, Resolution usual) {
    return size == RunSize::quick ? quick_resolution : usual;
}

std::optional<std::vector<std::string>> oracles_for(RunSize size) {
    if (size == RunSize::quick) return {{"none"}};
    if (size == RunSize::thorough) return {{"povray", "opengl"}};
    return std::nullopt;
}

std::vector<SceneSource> sources_for(RunSize size, Resolution resolution,
                                     const std::vector<SceneSource>& named) {
    std::vector<SceneSource> sources;
    for (const SceneSource& source : named) {
        if (source.only_thorough && size != RunSize::thorough) continue;
        sources.push_back(source);
        if (size == RunSize::usual && resolution == default_resolution)
            sources.back().size = source.usual_size;
        if (size != RunSize::thorough || states_its_size(source)) continue;
        for (const Resolution& further : further_resolutions) sources.push_back(at(source, further));
    }
    for (std::size_t i = 0; i < sources.size(); ++i) sources[i].place = i;
    return sources;
}

}  // namespace zproof
