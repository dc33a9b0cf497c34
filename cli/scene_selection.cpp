#include "cli/scene_selection.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "cli/nearest_word.h"
#include "scenes/gltf.h"
#include "scenes/judged_ranges.h"
#include "scenes/scene_error.h"
#include "scenes/suite.h"
#include "scenes/view_file.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

SceneSource of_suite(const SuiteEntry& entry) {
    return {SceneSource::Kind::suite, entry.name, "suite", entry.reason, entry.expects, 0};
}

/// In lower case.
std::string extension_of(const fs::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return extension;
}

bool is_gltf(const fs::path& file) { return extension_of(file) == ".gltf" || extension_of(file) == ".glb"; }

bool is_view_file(const fs::path& file) { return extension_of(file) == ".json"; }

/// "room" for room.gltf, room.glb, room.json and room.view.json.
std::string stem_of(const fs::path& file) {
    const fs::path stem = file.stem();
    return extension_of(stem) == ".view" ? stem.stem().string() : stem.string();
}

SceneSource of_file(const fs::path& file) {
    const auto kind = is_gltf(file) ? SceneSource::Kind::gltf : SceneSource::Kind::view_file;
    return {kind, stem_of(file), file.generic_string(), "", {}, 0};
}

bool found_in_folder(const fs::path& file) {
    if (is_view_file(file)) return extension_of(file.stem()) == ".view";
    std::error_code ignored;
    return is_gltf(file) && !fs::exists(file.parent_path() / (stem_of(file) + ".view.json"), ignored);
}

/// The scenes below the folder, and what cannot be looked at: load() refuses that, and says why.
void gather(const fs::path& folder, std::vector<fs::path>& found) {
    std::error_code failure, ignored;
    for (auto i = fs::directory_iterator(folder, failure); !failure && i != end(i); i.increment(failure)) {
        if (i->symlink_status(ignored).type() == fs::file_type::directory)
            gather(i->path(), found);
        else if (found_in_folder(i->path()) && !i->is_directory(ignored))
            found.push_back(i->path());
    }
    if (failure) found.push_back(folder);
}

std::vector<SceneSource> of_folder(const fs::path& folder) {
    std::vector<fs::path> files;
    gather(folder, files);
    std::ranges::sort(files);
    std::vector<SceneSource> sources;
    std::ranges::transform(files, std::back_inserter(sources), of_file);
    return sources;
}

SceneError unknown_word(const std::string& word, const std::vector<SuiteEntry>& manifest) {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : manifest) names.push_back(entry.name);
    return SceneError{word + ": no such file, folder or suite scene" + did_you_mean(word, names) +
                      " (zproof list shows the suite)"};
}

std::optional<SceneSource> single_scene(const std::string& word, const std::vector<SuiteEntry>& manifest) {
    const auto entry = std::ranges::find(manifest, word, &SuiteEntry::name);
    if (entry != manifest.end()) return of_suite(*entry);
    std::error_code failure;
    if (fs::is_directory(word, failure)) return std::nullopt;
    if (fs::status(word, failure).type() == fs::file_type::not_found) throw unknown_word(word, manifest);
    if (!is_gltf(word) && !is_view_file(word))
        throw SceneError{word +
                         ": not a scene; expected a file ending in .gltf, .glb or .json (a view file)"};
    return of_file(word);
}

std::vector<SceneSource> meant_by(const std::string& word, const std::vector<SuiteEntry>& manifest) {
    if (word == "suite") {
        std::vector<SceneSource> sources;
        std::ranges::transform(manifest, std::back_inserter(sources), of_suite);
        return sources;
    }
    if (const auto scene = single_scene(word, manifest)) return {*scene};
    return of_folder(word);
}

/// Scenes that share a name are called by their files instead.
void make_names_unique(std::vector<SceneSource>& sources) {
    std::map<std::string, int> uses;
    for (const SceneSource& source : sources) ++uses[source.name];
    for (SceneSource& source : sources)
        if (uses[source.name] > 1 && source.kind != SceneSource::Kind::suite) source.name = source.origin;
}

}  // namespace

std::vector<SceneSource> select_scenes(const std::vector<std::string>& words, const fs::path& models) {
    const std::vector<SuiteEntry> manifest = suite_manifest();
    std::vector<SceneSource> sources;
    std::set<std::string> seen;
    for (const std::string& word : words.empty() ? std::vector<std::string>{"suite"} : words)
        for (SceneSource& source : meant_by(word, manifest))
            if (seen.insert(word_for(source)).second) sources.push_back(std::move(source));
    make_names_unique(sources);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        sources[i].place = i;
        sources[i].models = models;
    }
    return sources;
}

SceneSource select_scene(const std::string& word, const fs::path& models) {
    if (auto scene = single_scene(word, suite_manifest())) {
        scene->models = models;
        return *scene;
    }
    throw SceneError{word + ": a folder, where one scene was expected; name a file in it"};
}

namespace {

Loaded loaded_as_it_is(const SceneSource& source, Resolution resolution) {
    std::error_code ignored;  // a loop of links is no folder, and is refused when it is read
    if (source.kind != SceneSource::Kind::suite && fs::is_directory(source.origin, ignored))
        throw SceneError{source.origin + ": folder cannot be read; expected one that may be listed (ls -l)"};
    switch (source.kind) {
        case SceneSource::Kind::suite:
            return generate_suite_scene(source.name, resolution.width, resolution.height);
        case SceneSource::Kind::gltf:
            return load_gltf(source.origin, resolution.width, resolution.height);
        case SceneSource::Kind::view_file:
            return load_view_file(source.origin, source.models);
    }
    throw std::logic_error{"a scene source of no kind"};
}

}  // namespace

Loaded load(const SceneSource& source, Resolution resolution) {
    Loaded loaded = loaded_as_it_is(source, resolution);
    require_judged(loaded.scene);
    return loaded;
}

std::string names_of(const std::vector<View>& views) {
    std::string names;
    for (const View& view : views) names += (names.empty() ? "" : ", ") + view.name;
    return names;
}

std::string word_for(const SceneSource& source) {
    return source.kind == SceneSource::Kind::suite ? source.name : source.origin;
}

}  // namespace zproof
