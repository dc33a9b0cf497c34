#include "program/study_scenes.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "frame/printable.h"
#include "program/nearest_word.h"
#include "program/scene_selection.h"
#include "program/usage_error.h"
#include "reports/notes.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"

namespace zproof {
namespace {

/// The worked set-up (docs/filter-scenes.md); its figures hold for these rows of this size.
constexpr const char* worked = "worked";
constexpr int worked_side = 256, worked_first_row = 56;

bool is_there(const std::string& word) {
    std::error_code ignored;
    return std::filesystem::exists(std::filesystem::symlink_status(word, ignored));
}

[[noreturn]] void refuse(const std::string& word, const std::vector<FilterSceneEntry>& built_in) {
    std::vector<std::string> names;
    for (const FilterSceneEntry& entry : built_in) names.push_back(entry.name);
    throw SceneError{word + ": no such filter scene, suite scene or file" + did_you_mean(word, names) +
                     " (zproof filters list shows the scenes)"};
}

bool is_of_the_suite_or_a_file(const std::string& word) {
    try {
        select_scene(word);
        return true;
    } catch (const SceneError&) {
        if (is_there(word)) throw;  // there, but no scene: its own words say why
        return false;
    }
}

StudyScene meant_by(const std::string& word, const std::vector<FilterSceneEntry>& built_in) {
    const auto entry = std::ranges::find(built_in, word, &FilterSceneEntry::name);
    if (entry != built_in.end()) return {word, entry->reason};
    if (is_photograph(word) && is_there(word)) return {word, {}};
    if (!is_of_the_suite_or_a_file(word)) refuse(word, built_in);
    return {word, {}};
}

}  // namespace

std::vector<StudyScene> study_scenes(const std::vector<std::string>& words) {
    const std::vector<FilterSceneEntry> built_in = filter_scenes();
    std::vector<StudyScene> scenes;
    for (const std::string& word : words) scenes.push_back(meant_by(word, built_in));
    if (words.empty())
        for (const FilterSceneEntry& entry : built_in) scenes.push_back({entry.name, entry.reason});
    return scenes;
}

Loaded load(const StudyScene& scene, Resolution resolution) {
    const std::vector<FilterSceneEntry> built_in = filter_scenes();
    if (std::ranges::find(built_in, scene.word, &FilterSceneEntry::name) != built_in.end())
        return generate_filter_scene(scene.word, resolution.width, resolution.height);
    if (is_photograph(scene.word)) return photograph_scene(scene.word, resolution.width, resolution.height);
    return load(select_scene(scene.word), resolution);
}

Resolution natural_resolution(const StudyScene& scene) {
    return scene.word == worked ? Resolution{worked_side, worked_side} : Resolution{512, 512};
}

int natural_first_row(const StudyScene& scene, int height) {
    return scene.word == worked ? worked_first_row * height / worked_side : 0;
}

Loaded load(const StudyScene& scene, const AskedSize& asked, const CommonArguments& common) {
    const Resolution natural = natural_resolution(scene),
                     size{asked.width.value_or(natural.width), asked.height.value_or(natural.height)};
    Loaded loaded = load(scene, size);
    if (!common.is_quiet()) std::cerr << note_lines(loaded.scene.name, loaded.scene.notes);
    const auto other = std::ranges::find_if(loaded.views, [&](const View& view) {
        return (asked.width && view.width != size.width) || (asked.height && view.height != size.height);
    });
    if (other != loaded.views.end() && !common.is_quiet())
        std::cerr << "zproof: " << one_line(scene.word) << ": the view '" << one_line(other->name)
                  << "' states its own size, " << other->width << " x " << other->height
                  << "; --width and --height change nothing\n";
    return loaded;
}

std::vector<View> chosen_views(const Loaded& loaded, const std::vector<std::string>& requested) {
    std::vector<View> chosen;
    for (const View& view : loaded.views)
        if (requested.empty() || std::ranges::find(requested, view.name) != requested.end())
            chosen.push_back(view);
    std::ranges::for_each(chosen, [](const View& view) { require_judged(view); });
    if (chosen.empty())
        throw UsageError{"--view: scene '" + loaded.scene.name + "' has no such view; it has " +
                         names_of(loaded.views)};
    return chosen;
}

}  // namespace zproof
