#include "program/scene_selection.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "frame/joined.h"
#include "program/nearest_word.h"
#include "program/samples.h"
#include "program/usage_error.h"
#include "reports/output_manifest.h"
#include "reports/wording.h"
#include "scenes/judged_ranges.h"
#include "scenes/model_file.h"
#include "scenes/random_scenes.h"
#include "scenes/scene_error.h"
#include "scenes/suite.h"
#include "scenes/view_file.h"

namespace zproof {

namespace {

namespace fs = std::filesystem;

SceneSource of_suite(const SuiteEntry& entry) {
    SceneSource source{SceneSource::Kind::suite, entry.name, "suite", entry.reason, entry.expects};
    source.usual_size = entry.size;
    source.has_own_sizes = entry.has_own_sizes;
    return source;
}

SceneSource of_thorough_suite(const SuiteEntry& entry) {
    SceneSource source = of_suite(entry);
    source.only_thorough = true;
    return source;
}

/// All that a word may name.
std::vector<SuiteEntry> named_scenes() {
    std::vector<SuiteEntry> entries = suite_manifest();
    std::ranges::move(thorough_manifest(), std::back_inserter(entries));
    return entries;
}

SceneSource of_chance(const RandomScene& scene) {
    const std::string word = word_of(scene);
    const auto kind = std::ranges::find(random_kinds(), scene.kind, &RandomKind::name);
    return {SceneSource::Kind::random, word, word, std::string(kind->reason), {}, 0};
}

bool is_view_file(const fs::path& file) { return ending_of(file) == ".json"; }

/// "room" for room.gltf, room.obj, room.json and room.view.json.
std::string stem_of(const fs::path& file) {
    const fs::path stem = file.stem();
    return ending_of(stem) == ".view" ? stem.stem().string() : stem.string();
}

SceneSource of_file(const fs::path& file) {
    const auto kind = is_model(file) ? SceneSource::Kind::model : SceneSource::Kind::view_file;
    return {kind, stem_of(file), file.generic_string(), "", {}, 0};
}

bool has_view_file(const fs::path& model) {
    std::error_code ignored;
    return fs::exists(model.parent_path() / (stem_of(model) + ".view.json"), ignored);
}

/// Is it the output folder of a run?
bool holds_results(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / output_marker, ignored) && fs::exists(folder / "results.json", ignored);
}

/// What lies below a folder, but for what zproof wrote about scenes.
class FolderWalk {
  public:
    explicit FolderWalk(const fs::path& folder) {
        gather(folder);
        std::ranges::sort(found_);
    }

    /// Scenes, and what cannot be looked at: load() refuses that, and says why.
    std::vector<SceneSource> sources() const {
        std::vector<SceneSource> sources;
        std::ranges::transform(found_, std::back_inserter(sources), of_file);
        return sources;
    }
    const FileCounts& passed_over() const { return passed_over_; }

  private:
    void gather(const fs::path& folder) {
        std::error_code failure, ignored;
        for (auto i = fs::directory_iterator(folder, failure); !failure && i != end(i); i.increment(failure))
            if (i->symlink_status(ignored).type() == fs::file_type::directory)
                gather_unless_results(i->path());
            else if (!i->is_directory(ignored) && i->path().filename() != output_marker)
                take(i->path());
        if (failure) found_.push_back(folder);
    }

    void gather_unless_results(const fs::path& folder) {
        if (!holds_results(folder)) gather(folder);
    }

    void take(const fs::path& file) {
        const bool is_view = is_view_file(file) && ending_of(file.stem()) == ".view";
        if (is_view || (is_model(file) && !has_view_file(file)))
            found_.push_back(file);
        else if (!is_model(file))
            ++passed_over_[ending_of(file)];
    }

    std::vector<fs::path> found_;
    FileCounts passed_over_;
};

/// Is it an output folder of zproof's, or the results in one?
bool is_of_results(const fs::path& path) {
    std::error_code ignored;
    if (path.filename() == "results.json") return fs::exists(path.parent_path() / output_marker, ignored);
    return fs::exists(path / output_marker, ignored);
}

SceneError no_scene_but_results(const std::string& word) {
    return SceneError{word +
                      ": holds the results of zproof, not scenes; name the scenes to judge (zproof report "
                      "shows results again)"};
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
    if (const auto scene = random_scene_from(word)) return of_chance(*scene);
    std::error_code failure;
    if (fs::is_directory(word, failure)) return std::nullopt;
    if (fs::status(word, failure).type() == fs::file_type::not_found) throw unknown_word(word, manifest);
    if (is_of_results(word)) throw no_scene_but_results(word);
    if (!is_model(word) && !is_view_file(word))
        throw SceneError{word + ": not a scene; expected a file ending in " + model_endings +
                         ", or .json (a view file); export any other model as .glb"};
    return of_file(word);
}

SceneSelection meant_by(const std::string& word, const std::vector<SuiteEntry>& manifest) {
    if (word == "suite") {
        std::vector<SceneSource> sources;
        std::ranges::transform(suite_manifest(), std::back_inserter(sources), of_suite);
        std::ranges::transform(thorough_manifest(), std::back_inserter(sources), of_thorough_suite);
        return {sources, {}};
    }
    if (const auto scene = single_scene(word, manifest)) return {{*scene}, {}};
    const FolderWalk walk(word);
    if (walk.sources().empty() && is_of_results(word)) throw no_scene_but_results(word);
    return {walk.sources(), walk.passed_over()};
}

/// Scenes that share a name are called by their files instead.
void make_names_unique(std::vector<SceneSource>& sources) {
    std::map<std::string, int> uses;
    for (const SceneSource& source : sources) ++uses[source.name];
    for (SceneSource& source : sources)
        if (uses[source.name] > 1 && source.kind != SceneSource::Kind::suite) source.name = source.origin;
}

}  // namespace

SceneSelection select_with_counts(const std::vector<std::string>& words, const fs::path& models) {
    const std::vector<SuiteEntry> manifest = named_scenes();
    SceneSelection selection;
    std::set<std::string> seen;
    for (const std::string& word : words.empty() ? std::vector<std::string>{"suite"} : words) {
        SceneSelection meant = meant_by(word, manifest);
        for (SceneSource& source : meant.sources)
            if (seen.insert(word_for(source)).second) selection.sources.push_back(std::move(source));
        for (const auto& [ending, count] : meant.passed_over) selection.passed_over[ending] += count;
    }
    make_names_unique(selection.sources);
    for (std::size_t i = 0; i < selection.sources.size(); ++i) {
        selection.sources[i].place = i;
        selection.sources[i].models = models;
    }
    return selection;
}

std::vector<SceneSource> select_scenes(const std::vector<std::string>& words, const fs::path& models) {
    std::vector<SceneSource> sources = select_with_counts(words, models).sources;
    std::erase_if(sources, &SceneSource::only_thorough);
    return sources;
}

std::string in_words(const FileCounts& passed_over) {
    constexpr std::size_t most_named = 6;
    std::vector<std::pair<std::string, std::uint64_t>> endings(passed_over.begin(), passed_over.end());
    std::ranges::stable_sort(endings, std::greater{}, [](const auto& ending) { return ending.second; });
    std::uint64_t all = 0;
    std::string text;
    for (std::size_t i = 0; i < endings.size(); ++i) {
        const auto& [ending, count] = endings[i];
        all += count;
        if (i >= most_named) continue;
        text += (i == 0 ? "" : ", ") + grouped(count) + " " + (ending.empty() ? "without an ending" : ending);
    }
    if (all == 0) return "";
    return counted(all, "file") + " passed over: " + text + (endings.size() > most_named ? ", ..." : "");
}

SceneSource select_scene(const std::string& word, const fs::path& models) {
    if (auto scene = single_scene(word, named_scenes())) {
        scene->models = models;
        return *scene;
    }
    if (is_of_results(word) && FolderWalk(word).sources().empty()) throw no_scene_but_results(word);
    throw SceneError{word + ": a folder, where one scene was expected; name a file in it"};
}

namespace {

bool is_file(const SceneSource& source) {
    return source.kind == SceneSource::Kind::model || source.kind == SceneSource::Kind::view_file;
}

Loaded loaded_as_it_is(const SceneSource& source, Resolution resolution) {
    std::error_code ignored;  // a loop of links is no folder, and is refused when it is read
    if (is_file(source) && fs::is_directory(source.origin, ignored))
        throw SceneError{source.origin + ": folder cannot be read; expected one that may be listed (ls -l)"};
    switch (source.kind) {
        case SceneSource::Kind::suite:
            return generate_suite_scene(word_for(source), resolution.width, resolution.height);
        case SceneSource::Kind::random:
            return generate(random_scene_from(source.origin).value());
        case SceneSource::Kind::model:
            return load_model(source.origin, resolution.width, resolution.height);
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

std::string names_of(const std::vector<View>& views) { return joined(views, ", ", &View::name); }

std::vector<View> views_named(const Loaded& loaded, const std::string& name) {
    std::vector<View> views = loaded.views;
    if (name.empty()) return views;
    std::erase_if(views, [&](const View& view) { return view.name != name; });
    if (!views.empty()) return views;
    throw UsageError{"--view " + name + ": " + loaded.scene.name + " has the views " +
                     names_of(loaded.views)};
}

bool states_its_size(const SceneSource& source) {
    return source.kind == SceneSource::Kind::view_file || source.kind == SceneSource::Kind::random ||
           source.has_own_sizes;
}

std::string word_for(const SceneSource& source) {
    if (source.kind != SceneSource::Kind::suite) return source.origin;
    return source.suite_name.empty() ? source.name : source.suite_name;
}

namespace {

std::vector<std::string> shown_names(const std::vector<View>& views) {
    std::vector<std::string> names;
    std::ranges::transform(views, std::back_inserter(names), shown_name);
    return names;
}

}  // namespace

std::vector<std::size_t> places_in(const ViewShare& share, const std::vector<View>& views) {
    if (share.planned) {
        if (share.planned->all != shown_names(views))
            throw SceneError{
                "the scene has other views than the plan says: it was changed; make the plan again"};
        return share.planned->wanted;
    }
    std::vector<std::size_t> places;
    for (std::size_t i = share.first; i < views.size(); i += share.stride)
        if (share.only.empty() || std::ranges::count(share.only, shown_name(views[i])) > 0)
            places.push_back(i);
    return places;
}

}  // namespace zproof
