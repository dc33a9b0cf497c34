/// Everything a run found out: the one input of every report, and the shape of results.json.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/diagnosis/diagnosis.h"
#include "compare/picture_difference.h"
#include "compare/verdict.h"
#include "compare/waivers/coverage.h"
#include "frame/id_agreement.h"

namespace zproof {

/// The time of each stage of a scene, seconds of wall clock.
struct StageTimes {
    double load = 0, render = 0, reference_build = 0, reference = 0, judge = 0, oracles = 0, write = 0;
};

/// A finding with its sentence and the command that tells more.
struct ReportedFinding {
    Finding finding;
    std::string explanation;
    std::string command;   ///< "zproof explain SCENE X Y"
    std::string waiver{};  ///< the id of the one that lets it pass; empty: none
};

enum class Outcome {
    proven,          ///< judged, no defect
    defective,       ///< at least one pixel fails the gate, or an expected class did not occur
    undecided,       ///< judged, no defect, but some pixels are undecidable at the declared precision
    unreadable,      ///< the input or a tool refused; `message` says why
    not_judged,      ///< nothing to judge (no triangles)
    internal_error,  ///< a fault of zproof's own ended the work on the scene; `message` says how
};

inline constexpr std::array all_outcomes{Outcome::proven,     Outcome::defective,  Outcome::undecided,
                                         Outcome::unreadable, Outcome::not_judged, Outcome::internal_error};

/// The outcome in words: "not judged".
std::string_view in_words(Outcome outcome);

/// The outcome's name in results.json: "not_judged".
std::string_view name_of(Outcome outcome);

/// The sign before the word: "✓".
std::string_view glyph_of(Outcome outcome);

/// Who a renderer is.
struct RendererFacts {
    std::string name;
    std::string version;    ///< in its own words; empty where it has none
    std::string precision;  ///< what it declares, as JSON (frame/precision_text.h)
    /// What the ids of its frames stand for (scenes/triangle_labels.h): "triangle", "material", "none" ...
    std::string ids = "triangle";
};

/// Name and version: "povray POV-Ray 3.7"; the version alone where it begins with the name, "Embree 4.3".
std::string title_of(const RendererFacts& renderer);

/// What its ids stand for: "ids: material"; "depth only" where it has none.
std::string ids_in_words(const RendererFacts& renderer);

/// Those pixels of a view that a renderer was asked about: every stride-th of every stride-th row.
struct SampledPixels {
    int stride = 1, first_x = 0, first_y = 0;
    std::uint64_t pixels = 0;
    std::uint64_t seed = 0;       ///< by which the first was drawn
    std::string fewer_because{};  ///< why they are fewer than in other views; empty: they are not
};

/// One more renderer, judged against the same reference. Its defects are its own: they do not fail the view.
struct OracleResult {
    std::string name;
    std::string absent;  ///< why it was not compared; empty: it was
    ClassCounts counts{};
    BoundRecord depth{}, edges{};          ///< depth error / bound; displacement / eps
    std::vector<ReportedFinding> worst{};  ///< its defects, at most 20
    std::optional<PictureDifferences>
        picture{};                          ///< of its colours from the candidate's, where both were painted
    std::string no_picture{};               ///< why it could not paint; empty: it could, or was not asked
    std::optional<SampledPixels> sample{};  ///< nothing: it was asked about all pixels
};

/// How large a scene and its picture are.
struct SceneSize {
    std::uint64_t triangles = 0;
    int width = 0, height = 0;
};

/// A smaller scene that fails as the view does (docs/random.md).
struct ShrunkView {
    std::string file;  ///< its view file, relative to results.json
    SceneSize before{}, after{};
    int tries = 0;        ///< smaller scenes that were rendered
    std::string command;  ///< that shows it
};

/// One view of one scene, judged.
struct ViewResult {
    std::string scene;   ///< scene name
    std::string source;  ///< file, or "suite"
    std::string view;
    std::string reason;  ///< why the suite has it; empty for users' files
    Outcome outcome = Outcome::proven;
    std::string message;  ///< one line where outcome is unreadable or not_judged, or an expectation failed
    int width = 0, height = 0;
    std::uint64_t triangles = 0;
    std::string candidate, reference;  ///< renderer names
    ClassCounts counts{};
    ClassCounts waived{};              ///< of those: pixels that a waiver lets pass
    std::vector<WaiverUse> waivers{};  ///< those that name this view
    BoundRecord candidate_depth, reference_depth;
    BoundRecord candidate_edges, reference_edges;  ///< displacement over eps
    std::uint64_t reference_defects = 0, adjudicated = 0, exact = 0;
    std::optional<Diagnosis> diagnosis;  ///< of the defects; nothing where there are none
    std::vector<OracleResult> oracles;
    IdAgreement id_agreement;  ///< of candidate, reference and the oracles that were compared, in this order
    std::vector<ReportedFinding> worst;     ///< defects first, then by error/bound; at most 200
    std::vector<std::string> notes;         ///< of the scene
    std::vector<std::string> attributes{};  ///< of the candidate's frame: those that were judged
    StageTimes times;
    std::string folder;       ///< scenes/NAME, relative to results.json; empty: no evidence was left
    std::uint64_t place = 0;  ///< of its scene among those that the command line selected
    std::uint64_t view_place = 0, scene_views = 0;  ///< among its scene's views, and how many these are; 0, 0
                                                    ///< of what stands for the whole scene
    std::vector<std::string> expects{};             ///< classes of which its scene's views must have a pixel
    std::string scene_sha256{};                     ///< sha256_of(Scene); empty where it was not read
    std::string command{};                          ///< its own run's; empty: Results::command
    std::optional<ShrunkView> shrunk{};             ///< of a random scene that fails in a way of its own
};

/// Has the judge seen it? Only then do counts and depth records say something.
bool was_judged(const ViewResult& view);

/// Is it neither proven nor left unjudged?
bool failed(const ViewResult& view);

/// Does it stand for a whole scene? One that could not be read or was not begun has views, nobody knows how
/// many.
bool stands_for_a_scene(const ViewResult& view);

/// Pixels whose class fails the gate, waived or not.
std::uint64_t defect_count(const ClassCounts& counts);
std::uint64_t defect_count(const ViewResult& view);

std::uint64_t waived_count(const ViewResult& view);      ///< of those: let pass by waivers
std::uint64_t unwaived_defects(const ViewResult& view);  ///< the others: they fail the gate

/// The largest error/bound of the candidate's depths; "-" where there are defects, and none is of a depth:
/// the depth of a triangle that must not be seen may well be right.
std::string error_over_bound_words(const ViewResult& view);

/// All stages together, seconds.
double seconds(const StageTimes& times);

/// Does a waiver that does less than it says fail the gate?
enum class Strictness { lenient, strict };

/// Which share of the selected views a run judged.
struct Shard {
    int number = 1, count = 1;  ///< 1 <= number <= count; the whole is 1/1
    std::string plan{};         ///< the SHA-256 of the plan that says which; empty: by hash
    std::string taken_from{};   ///< the environment variable that told the number; empty: it was typed
};

/// What the command line selected, of which a shard judges a part.
struct Selection {
    std::uint64_t scenes = 0;
    std::string sha256{};  ///< of their words, a line each: the same for all shards of one run
    std::map<std::string, std::uint64_t> passed_over{};  ///< files in folders that are no scenes, by ending
};

enum class Ending {
    complete,
    interrupted,
    stopped,  ///< as its rule says: after so many views that failed
    partial,  ///< shards that were put together, and some were missing
};

inline constexpr std::array all_endings{Ending::complete, Ending::interrupted, Ending::stopped,
                                        Ending::partial};

/// The ending's name in results.json: "interrupted".
std::string_view name_of(Ending ending);

/// Are causes of failed views sought?
enum class CauseSearch { left_out, done };

/// A whole run.
struct Results {
    static constexpr const char* schema_version = "2.0";
    std::string version;              ///< zproof's
    std::string commit{};             ///< that it was built from; empty in results of older versions
    std::string command;              ///< as typed, quoted for a shell
    std::vector<std::string> argv{};  ///< as typed, word by word, without "zproof"
    std::string compiler, embree;
    int threads = 0;
    std::string isa{};  ///< the instruction set, "avx2"; empty in results of older versions
    Shard shard{};
    Selection selection{};
    Ending ending = Ending::complete;
    std::string today{};  ///< the day that waivers are held against, "2026-04-10"; empty where there are none
    CauseSearch diagnosis = CauseSearch::done;
    Strictness strictness = Strictness::lenient;
    std::vector<Waiver> waivers{};
    std::vector<RendererFacts> renderers;  ///< candidate, reference, and the oracles that are there
    std::vector<ViewResult> views;
};

/// The views in reading order: defective, internal error, undecided, unreadable, not judged, proven; each in
/// the order of the run.
std::vector<const ViewResult*> failed_first(const Results& results);

}  // namespace zproof
