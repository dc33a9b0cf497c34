/// The fields of results.json, each declared once, in the order of the file (frame/field.h). The findings'
/// own are those of compare/finding.h; the views stand last, and are read and written one by one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "frame/attributes.h"
#include "frame/field.h"
#include "reports/results.h"
#include "reports/run_causes.h"

namespace zproof {

/// Values that stand in JSON in another form than their types do.
struct Sparse;    ///< by class, those without a pixel left out
struct Channel;   ///< an index of attribute_channels, as its name
struct JsonText;  ///< JSON as it is
struct Flag;      ///< a choice of two, as true or false

/// What the values of an enumeration are called, together, and which there are.
template <class Enum>
struct Words;
template <>
struct Words<PixelClass> {
    static constexpr std::string_view noun = "pixel class";
    static constexpr auto values = [] {
        std::array<PixelClass, pixel_class_count> all{};
        for (int i = 0; i < pixel_class_count; ++i) all[std::size_t(i)] = PixelClass(i);
        return all;
    }();
};
template <>
struct Words<Outcome> {
    static constexpr std::string_view noun = "outcome";
    static constexpr auto values = all_outcomes;
};
template <>
struct Words<Ending> {
    static constexpr std::string_view noun = "ending";
    static constexpr auto values = all_endings;
};
template <>
struct Words<WaiverEffect> {
    static constexpr std::string_view noun = "effect of a waiver";
    static constexpr std::array values{WaiverEffect::holds,   WaiverEffect::fewer,
                                       WaiverEffect::none,    WaiverEffect::exceeded,
                                       WaiverEffect::expired, WaiverEffect::other_scene};
};

/// A list in JSON: its elements.
template <class Value>
inline constexpr auto elements_of = nullptr;
template <>
inline constexpr auto elements_of<Resolution> = [](auto& size) { return std::tie(size.width, size.height); };
template <>
inline constexpr auto elements_of<PixelRectangle> =
    [](auto& r) { return std::tie(r.x, r.y, r.width, r.height); };
template <>
inline constexpr auto elements_of<std::pair<PrimitiveId, PrimitiveId>> =
    [](auto& pair) { return std::tie(pair.first, pair.second); };

template <class... Elements>
inline constexpr auto elements_of<std::tuple<Elements...>> = [](auto& references) { return references; };

template <class Value>
inline constexpr bool is_list = !std::is_same_v<decltype(elements_of<Value>), const std::nullptr_t>;

template <class Value>
inline constexpr bool is_vector = false;
template <class Element>
inline constexpr bool is_vector<std::vector<Element>> = true;

/// Is what a row gives read back? A reference, to the record itself or within.
template <class Value>
inline constexpr bool is_read = std::is_lvalue_reference_v<Value>;
template <class Form, class Value>
inline constexpr bool is_read<As<Form, Value>> = true;
template <class... Elements>
inline constexpr bool is_read<std::tuple<Elements...>> = true;

/// Limits that a schema tells.
inline constexpr std::string_view sha256_or_empty = R"({"pattern": "^([0-9a-f]{64})?$"})",
                                  from_0 = R"({"type": "number", "minimum": 0})",
                                  from_1 = R"({"minimum": 1})";

inline constexpr auto unless_empty = FieldFacts::Presence::unless_empty;

template <>
inline constexpr auto fields<WrongAttribute> = std::tuple{
    ObjectFacts{"wrong_attribute"},
    field("channel", as<Channel>(&WrongAttribute::channel)),
    field("value", &WrongAttribute::value),
    field("low", &WrongAttribute::low, "least admissible value"),
    field("truth", &WrongAttribute::truth, "that at the centre"),
    field("high", &WrongAttribute::high, "largest admissible value"),
    field("error_over_bound", &WrongAttribute::error_over_bound),
};

template <>
inline constexpr auto fields<ReportedFinding> = std::tuple_cat(
    std::tuple{
        ObjectFacts{"finding"}, ObjectFacts{"candidate", "What the renderer under test said."},
        ObjectFacts{"reference", "What the reference said."},
        ObjectFacts{"candidate_depth_bound",
                    "Depths that a faultless renderer may report for the candidate's id, and the true one."}},
    within(&ReportedFinding::finding, fields<Finding>),
    std::tuple{
        field("explanation", &ReportedFinding::explanation),
        field("command", &ReportedFinding::command, "that tells more"),
        field("waiver", &ReportedFinding::waiver, "the id of the waiver that lets the pixel pass",
              {.presence = unless_empty}),
        field("wrong_attribute", at(&ReportedFinding::finding, &Finding::wrong_attribute),
              "the interpolated value that makes the pixel wrong_attribute, and the admissible ones",
              {.presence = unless_empty}),
    });

template <>
inline constexpr auto fields<BoundRecord> = std::tuple{
    ObjectFacts{"bound_record", "Error / bound."},
    field("max_error_over_bound", &BoundRecord::max_error_over_bound),
    field("histogram", &BoundRecord::histogram,
          "20 bins of 0.05, then everything from 1 up; absent where nothing was counted: as of edges "
          "in a view whose frames agree everywhere",
          {.presence = unless_empty}),
};

template <>
inline constexpr auto fields<Explanation> = std::tuple{
    ObjectFacts{"explanation",
                "A hypothesis about the renderer, and what the judge found when it supposed it."},
    field("name", &Explanation::name),
    field("description", &Explanation::description),
    field("look_at", &Explanation::look_at, "where in a renderer's code to look first", {.since = "0.3"}),
    field("explained", &Explanation::explained, "defects that are admissible under it, of those asked"),
    field("asked", &Explanation::asked),
    field("contradicted", &Explanation::contradicted,
          "pixels that agree and are inadmissible under it, of those checked"),
    field("checked", &Explanation::checked),
    field("spared", &Explanation::saved_share,
          "of what it takes to tell the defects: the share that the hypothesis spares", {.since = "0.3"}),
    field("spared_bits", &Explanation::saved_bits, "the same in bits: by them views vote for the run's cause",
          {.since = "0.3"}),
    field("fitted", &Explanation::fitted,
          "the number that it fitted to the frames, as a clause: \"depth is told times 1.1\"",
          {.presence = unless_empty}),
};

template <>
inline constexpr auto fields<Diagnosis> = std::tuple{
    ObjectFacts{"diagnosis", "Why the view fails; null where it has no defects."},
    field("defects", &Diagnosis::defects, "of the whole view"),
    field("cause", &Diagnosis::cause, "the best explanation; null: no single cause"),
    field("further", &Diagnosis::further, "causes of the defects that the first leaves",
          {.since = "0.3", .limits = R"({"maxItems": 2})"}),
    field("runners_up", &Diagnosis::runners_up, "", {.limits = R"({"maxItems": 3})"}),
};

template <>
inline constexpr auto fields<PictureDifference> = std::tuple{
    ObjectFacts{"picture_difference"},
    field("pixels", &PictureDifference::pixels),
    field("rms", &PictureDifference::rms),
    field("mean", &PictureDifference::mean),
    field("largest", &PictureDifference::largest),
};

template <>
inline constexpr auto fields<SampledPixels> = std::tuple{
    ObjectFacts{"sample"},
    field("pixels", &SampledPixels::pixels),
    field("stride", &SampledPixels::stride),
    field(
        "first", [](auto& sample) { return std::tie(sample.first_x, sample.first_y); }, "x, y"),
    field("seed", &SampledPixels::seed, "by which the first was drawn"),
    field("fewer_because", &SampledPixels::fewer_because,
          "why they are fewer than in other views; empty: they are not"),
};

inline constexpr auto was_compared = [](const OracleResult& oracle) { return oracle.absent.empty(); };

template <>
inline constexpr auto fields<OracleResult> = std::tuple{
    ObjectFacts{
        "oracle",
        "A renderer that was asked besides candidate and reference, and judged against the same reference."},
    field("name", &OracleResult::name),
    field("absent", &OracleResult::absent, "why it was not compared; where empty, the other keys are there"),
    field_where(
        was_compared, "defects", [](const OracleResult& oracle) { return defect_count(oracle.counts); },
        "its own; they do not fail the view"),
    field_where(was_compared, "counts", &OracleResult::counts),
    field_where(was_compared, "depth", &OracleResult::depth),
    field_where(was_compared, "edges", &OracleResult::edges),
    field_where(was_compared, "worst", &OracleResult::worst, "", {.limits = R"({"maxItems": 20})"}),
    field_where(was_compared, "sample", &OracleResult::sample,
                "the pixels that it was asked about, where these are not all: every stride-th of every "
                "stride-th row, from `first` on, which the seed drew; its findings are in the pixels "
                "of the view",
                {.presence = unless_empty}),
    field_where(was_compared, "picture", &OracleResult::picture,
                "how far its colours lie from the candidate's in linear light, by class; with "
                "--pictures",
                {.presence = unless_empty}),
    field_where(was_compared, "no_picture", &OracleResult::no_picture, "why it could not paint",
                {.presence = unless_empty}),
};

template <>
inline constexpr auto fields<IdAgreement> = std::tuple{
    ObjectFacts{
        "id_agreement",
        "Pixels at which renderers name the same triangle: candidate, reference, and the oracles that were "
        "compared, in this order. Where an oracle was asked about a sample, only the pixels of the sample "
        "count."},
    field("same", &IdAgreement::same),
    field("unanimous", &IdAgreement::unanimous),
};

template <>
inline constexpr auto fields<SceneSize> = std::tuple{
    ObjectFacts{"scene_size"},
    field("triangles", &SceneSize::triangles),
    field("width", &SceneSize::width, "", {.unit = "px"}),
    field("height", &SceneSize::height, "", {.unit = "px"}),
};

template <>
inline constexpr auto fields<ShrunkView> = std::tuple{
    ObjectFacts{"shrunk"},
    field("file", &ShrunkView::file, "its view file, relative to this file"),
    field("before", &ShrunkView::before),
    field("after", &ShrunkView::after),
    field("tries", &ShrunkView::tries, "smaller scenes that were rendered"),
    field("command", &ShrunkView::command, "that shows the failure"),
};

template <>
inline constexpr auto fields<StageTimes> = std::tuple{
    ObjectFacts{"times", "Time of each stage, wall clock."},
    field("load", &StageTimes::load, "", {.unit = "s", .limits = from_0}),
    field("render", &StageTimes::render, "", {.unit = "s", .limits = from_0}),
    field("reference_build", &StageTimes::reference_build, "", {.unit = "s", .limits = from_0}),
    field("reference", &StageTimes::reference, "", {.unit = "s", .limits = from_0}),
    field("judge", &StageTimes::judge, "", {.unit = "s", .limits = from_0}),
    field("oracles", &StageTimes::oracles, "", {.unit = "s", .limits = from_0}),
    field("write", &StageTimes::write, "", {.unit = "s", .limits = from_0}),
};

template <>
inline constexpr auto fields<WaiverUse> = std::tuple{
    ObjectFacts{"waiver_use", "What a waiver did about one view."},
    field("id", &WaiverUse::id),
    field("effect", &WaiverUse::effect),
    field("matched", &WaiverUse::matched, "defects of its classes in its place"),
    field("waived", &WaiverUse::waived, "of those, let pass on its word"),
};

/// The kinds of a waiver's place, in the order of its alternatives.
inline constexpr std::array<std::string_view, std::variant_size_v<decltype(Waiver::where)>> waived_places{
    "anywhere", "triangles", "pairs", "pixels"};

template <>
inline constexpr auto fields<Anywhere> = std::tuple{ObjectFacts{"anywhere"}};
template <>
inline constexpr auto fields<AtTriangles> =
    std::tuple{ObjectFacts{"at_triangles"}, field("triangles", &AtTriangles::triangles)};
template <>
inline constexpr auto fields<AtPairs> =
    std::tuple{ObjectFacts{"at_pairs"}, field("pairs", &AtPairs::pairs, "candidate's and reference's")};
template <>
inline constexpr auto fields<AtPixels> =
    std::tuple{ObjectFacts{"at_pixels"}, field("size", &AtPixels::size, "width, height"),
               field("rectangles", &AtPixels::rectangles, "x, y, width, height")};

template <>
inline constexpr auto fields<Waiver> = std::tuple{
    ObjectFacts{"waiver",
                "A waiver as its file has it (docs/gate.md), and what the run as a whole says of it."},
    field("id", &Waiver::id),
    field("scene", &Waiver::scene),
    field("view", &Waiver::view),
    field("classes", &Waiver::classes),
    field("where", &Waiver::where),
    field("count/min", &Waiver::least),
    field("count/max", &Waiver::most),
    field("reason", &Waiver::reason),
    field("link", &Waiver::link),
    field("created", &Waiver::created),
    field("expires", &Waiver::expires),
    field("scene_sha256", &Waiver::scene_sha256, "", {.limits = sha256_or_empty}),
    field("origin", &Waiver::origin, "file:line"),
};

template <>
inline constexpr auto fields<ViewResult> = std::tuple{
    ObjectFacts{"view"},
    field("scene", &ViewResult::scene),
    field("source", &ViewResult::source, "file, or \"suite\""),
    field("view", &ViewResult::view),
    field("reason", &ViewResult::reason, "why the suite has this view"),
    field("outcome", &ViewResult::outcome),
    field("message", &ViewResult::message),
    field("width", &ViewResult::width, "", {.unit = "px"}),
    field("height", &ViewResult::height, "", {.unit = "px"}),
    field("triangles", &ViewResult::triangles),
    field("candidate", &ViewResult::candidate, "renderer under test"),
    field("reference", &ViewResult::reference, "renderer that it was held against"),
    field(
        "defects", [](const ViewResult& view) { return defect_count(view); },
        "pixels whose class fails the gate, waived or not"),
    field("counts", &ViewResult::counts, "pixels by class"),
    field("waived", as<Sparse>(&ViewResult::waived), "of those, pixels that a waiver lets pass, by class"),
    field("waivers", &ViewResult::waivers, "those that name this view"),
    field("candidate_depth", &ViewResult::candidate_depth,
          "over the pixels at which both name the same triangle"),
    field("reference_depth", &ViewResult::reference_depth),
    field("candidate_edges", &ViewResult::candidate_edges,
          "displacement / eps: where the renderers differ and this one's answer is admissible by its "
          "place but not right at the centre"),
    field("reference_edges", &ViewResult::reference_edges),
    field("reference_defects", &ViewResult::reference_defects,
          "pixels at which the reference's own answer is inadmissible"),
    field("adjudicated", &ViewResult::adjudicated, "pixels that needed the admissible set"),
    field("exact", &ViewResult::exact, "of those, pixels that needed exact rationals"),
    field("diagnosis", &ViewResult::diagnosis),
    field("oracles", &ViewResult::oracles),
    field("id_agreement", &ViewResult::id_agreement),
    field("worst", &ViewResult::worst, "defects first, then by error/bound",
          {.limits = R"({"maxItems": 200})"}),
    field("notes", &ViewResult::notes, "of the scene"),
    field("attributes", &ViewResult::attributes,
          "of the candidate's frame, those that were judged; absent where none was",
          {.since = "0.3", .presence = unless_empty}),
    field("folder", &ViewResult::folder, "the view's evidence, relative to this file; empty for none"),
    field("place", &ViewResult::place, "of its scene in the selection"),
    field("view_place", &ViewResult::view_place, "among its scene's views", {.since = "0.3"}),
    field("scene_views", &ViewResult::scene_views,
          "how many views its scene has; 0 of what stands for a whole scene", {.since = "0.3"}),
    field("scene_sha256", &ViewResult::scene_sha256,
          "of the baked scene (scenes/scene_hash.h); empty where it was not read",
          {.limits = sha256_or_empty}),
    field("times", &ViewResult::times),
    field("expects", &ViewResult::expects,
          "classes of which its scene's views must have a pixel; absent where the suite expects none",
          {.presence = unless_empty}),
    field("command", &ViewResult::command,
          "of the run that judged it, as typed; absent where that is run.command",
          {.since = "0.3", .presence = unless_empty}),
    field("shrunk", &ViewResult::shrunk,
          "a smaller scene that fails as this view does (docs/random.md); of the first random scene of "
          "each kind of failure",
          {.presence = unless_empty}),
};

template <>
inline constexpr auto fields<RendererFacts> = std::tuple{
    ObjectFacts{"renderer"},
    field("name", &RendererFacts::name),
    field("version", &RendererFacts::version, "in its own words; may be empty"),
    field("precision", as<JsonText>(&RendererFacts::precision),
          "what it declares (docs/renderer-contract.md)"),
    field("ids", &RendererFacts::ids,
          "what its ids stand for (docs/labels.md): triangle, material ...; none: depth alone was judged",
          {.since = "0.3"}),
};

template <>
inline constexpr auto fields<Shard> = std::tuple{
    ObjectFacts{"shard", "Which share of the selected scenes was judged; the whole is 1 of 1."},
    field("number", &Shard::number, "", {.limits = from_1}),
    field("count", &Shard::count, "", {.limits = from_1}),
    field("plan", &Shard::plan, "SHA-256 of the plan that says which views; absent: by hash",
          {.presence = unless_empty}),
    field("taken_from", &Shard::taken_from,
          "the environment variable that told the number; absent: it was typed", {.presence = unless_empty}),
};

template <>
inline constexpr auto fields<Selection> = std::tuple{
    ObjectFacts{"selection", "The scenes that the command line selected, all shards together."},
    field("scenes", &Selection::scenes),
    field("sha256", &Selection::sha256, "of their words, a line each; empty where nothing was selected",
          {.limits = sha256_or_empty}),
    field("passed_over", &Selection::passed_over,
          "number of files in the folders that are no scenes, by ending in lower case", {.since = "0.3"}),
};

template <>
inline constexpr auto fields<RunCause> = std::tuple{
    ObjectFacts{"run_cause", "The likely cause of some of the views that failed."},
    field("name", &RunCause::name),
    field("look_at", &RunCause::look_at, "where in a renderer's code to look first"),
    field("fitted", &RunCause::fitted, "the number that all of its views fit", {.presence = unless_empty}),
    field("views", &RunCause::views, "of which it is the likely cause"),
    field("spared_bits", &RunCause::saved_bits, "by it, in all of them"),
};

template <Outcome outcome>
std::uint64_t views_of(const Results& results) {
    return std::uint64_t(std::ranges::count(results.views, outcome, &ViewResult::outcome));
}

static_assert(all_outcomes.size() == 6);  // each has a row of summary

template <>
inline constexpr auto fields<Results> = std::tuple{
    ObjectFacts{
        "",
        "Everything that one zproof run found out. New keys may appear within 2.x; readers pass over "
        "what they do not know. Two runs of the same input differ in `run` and in each view's "
        "`times` only; those that are put together from shards in `diagnosis` too, where a shard did not "
        "meet a view that the whole run learned a cause from."},
    field("schema_version", [](const Results&) { return Results::schema_version; }, "",
          {.limits = R"({"pattern": "^2\\.[0-9]+$"})"}),
    ObjectFacts{"run", "How, where and by what the run was made."},
    field("run/version", &Results::version, "zproof's version"),
    field("run/commit", &Results::commit,
          "the commit that this zproof was built from, 12 digits, with ', changed' where tracked files "
          "differed from it; 'unknown' where there was no git",
          {.since = "0.3"}),
    field("run/command", &Results::command, "as typed"),
    field("run/argv", &Results::argv, "the same, word by word, without zproof"),
    field("run/compiler", &Results::compiler),
    field("run/embree", &Results::embree),
    field("run/threads", &Results::threads),
    field("run/isa", &Results::isa, "the widest instruction set that was used: scalar, avx2 or avx512",
          {.since = "0.3"}),
    field("run/shard", &Results::shard),
    field("run/ending", &Results::ending),
    field("run/today", &Results::today, "the day that waivers were held against; empty where there are none"),
    field("run/diagnosis", as<Flag>(&Results::diagnosis), "were causes of failed views sought?",
          {.since = "0.3"}),
    field("run/renderers", &Results::renderers, "candidate, reference and the oracles that could be asked"),
    field("selection", &Results::selection),
    ObjectFacts{"summary", "Number of views, in all and by outcome."},
    field("summary/views", [](const Results& results) { return std::uint64_t(results.views.size()); }),
    field("summary/proven", views_of<Outcome::proven>),
    field("summary/defective", views_of<Outcome::defective>),
    field("summary/undecided", views_of<Outcome::undecided>),
    field("summary/unreadable", views_of<Outcome::unreadable>),
    field("summary/not_judged", views_of<Outcome::not_judged>),
    field("summary/internal_error", views_of<Outcome::internal_error>),
    field("causes", run_causes, "of the whole run, the one first that spares the most bits",
          {.since = "0.3"}),
    field("waivers/strict", as<Flag>(&Results::strictness),
          "do unused and too generous waivers fail the gate?"),
    field("waivers/list", &Results::waivers),
};

}  // namespace zproof
