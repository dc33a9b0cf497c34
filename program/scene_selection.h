/// Turns words of a command line into the scenes that they mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frame/plane.h"
#include "scenes/loaded.h"
#include "scenes/view.h"

namespace zproof {

/// What a plan says of a scene.
struct PlannedViews {
    std::vector<std::string> all;     ///< that the scene had when the plan was made, as reports call them
    std::vector<std::size_t> wanted;  ///< places in it, ascending; of a scene without views: 0
};

/// Without a plan: the view `first`, and each stride-th after it, if it is among `only`. Every view, unless
/// told otherwise.
struct ViewShare {
    std::size_t first = 0, stride = 1;
    std::optional<PlannedViews> planned{};
    std::vector<std::string> only{};  ///< as reports call them; empty: all of those

    /// Does what there is to say of a scene without views belong to this share?
    bool has_the_first() const { return planned ? planned->wanted.front() == 0 : first == 0; }
};

/// The places of the share's views among the scene's, ascending. Throws SceneError where a plan speaks of
/// other views.
std::vector<std::size_t> places_in(const ViewShare& share, const std::vector<View>& views);

/// A scene that is known of, not yet loaded.
struct SceneSource {
    enum class Kind { suite, random, model, view_file };
    Kind kind = Kind::suite;
    std::string name;                  ///< unique within a selection: what the reports call it
    std::string origin;                ///< "suite", "random:KIND:SEED:NUMBER", or the file
    std::string reason;                ///< why it is there; empty for files
    std::vector<std::string> expects;  ///< classes that must occur; empty for files
    std::uint64_t place = 0;           ///< in the selection, from 0
    std::filesystem::path models{};    ///< where a view file's model may lie; empty: in its own folder only
    std::string suite_name{};          ///< where it goes by another name in the selection
    std::optional<Resolution> usual_size{};  ///< of a suite scene's pictures where a run names no other
    std::optional<Resolution> size{};        ///< of its pictures in this run; nothing: what the run has
    bool has_own_sizes = false;              ///< its views state their sizes
    bool only_thorough = false;              ///< the suite's, but of thorough runs alone
    ViewShare share{};                       ///< which of its views are judged
};

/// The scenes that the words mean, in their order, each once: "suite" or no word at all is the whole suite; a
/// folder is every .gltf, .glb, .obj, .ply and .view.json below it, sorted, where NAME.view.json speaks for a
/// NAME.gltf, NAME.glb, NAME.obj or NAME.ply beside it. A suite scene's name and random:KIND:SEED:NUMBER go
/// before a file of that name. The suite's scenes of thorough runs are among them where they are named.
/// Nothing is opened. Throws SceneError for a word that is none of this.
std::vector<SceneSource> select_scenes(const std::vector<std::string>& words,
                                       const std::filesystem::path& models = {});

/// How many files, by their ending in lower case.
using FileCounts = std::map<std::string, std::uint64_t>;

/// The scenes, with the whole suite's of thorough runs, and what lies beside them in the folders and is
/// none. A model that a view file speaks for is not counted.
struct SceneSelection {
    std::vector<SceneSource> sources;
    FileCounts passed_over;
};
SceneSelection select_with_counts(const std::vector<std::string>& words,
                                  const std::filesystem::path& models = {});

/// "12 files passed over: 9 .png, 3 .txt"; empty where there is none.
std::string in_words(const FileCounts& passed_over);

/// The one scene that the word means; a folder is not one. Throws SceneError.
SceneSource select_scene(const std::string& word, const std::filesystem::path& models = {});

/// Do its views state how large their pictures are? A run's resolution is not for them.
bool states_its_size(const SceneSource& source);

/// Loads or generates it. The resolution does not touch views that state their own. Throws SceneError, also
/// for a scene beyond the judged ranges; each view is to be held to them before it is rendered
/// (scenes/judged_ranges.h).
Loaded load(const SceneSource& source, Resolution resolution);

/// "door, floor": for messages.
std::string names_of(const std::vector<View>& views);

/// The views of that name; all where it is empty. Throws UsageError where there is none.
std::vector<View> views_named(const Loaded& loaded, const std::string& name);

/// What to type after "zproof explain" to mean this scene.
std::string word_for(const SceneSource& source);

}  // namespace zproof
