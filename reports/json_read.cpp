#include <algorithm>
#include <bit>
#include <charconv>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/json.h"
#include "reports/result_file.h"
#include "reports/waiver_json.h"
#include "reports/whole_number.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& why) { throw ReportError("results.json: " + why); }

double number(const Json& json) {
    if (!json.is_string()) return json.get<double>();
    const std::string& text = json.get_ref<const std::string&>();
    if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
    refuse("expected a number, \"nan\", \"inf\" or \"-inf\", found \"" + text + "\"");
}

std::uint64_t count(const Json& json) { return whole_number<std::uint64_t>(json); }

float float_from_bits(const std::string& text) {
    std::uint32_t bits = 0;
    const char* const end = text.data() + text.size();
    if (text.size() != 10 || !text.starts_with("0x") ||
        std::from_chars(text.data() + 2, end, bits, 16).ptr != end)
        refuse("expected the bits of a float32 such as 0x3f800000, found \"" + text + "\"");
    return std::bit_cast<float>(bits);
}

PixelClass class_named(const std::string& name) {
    for (int i = 0; i < pixel_class_count; ++i)
        if (name_of(PixelClass(i)) == name) return PixelClass(i);
    refuse("no pixel class is named \"" + name + "\"");
}

Outcome outcome_named(const std::string& name) {
    for (const Outcome outcome : all_outcomes)
        if (name_of(outcome) == name) return outcome;
    refuse("no outcome is named \"" + name + "\"");
}

Ending ending_named(const std::string& name) {
    for (const Ending ending : all_endings)
        if (name_of(ending) == name) return ending;
    refuse("no ending is named \"" + name + "\"");
}

PrimitiveId id(const Json& json) {
    return json.is_null() ? PrimitiveId::none : PrimitiveId(whole_number<std::uint32_t>(json));
}

Answer answer(const Json& json) {
    return {id(json.at("primitive")), float_from_bits(json.at("camera_depth_bits"))};
}

DepthBound bound(const Json& json) {
    return {number(json.at("low")), number(json.at("truth")), number(json.at("high"))};
}

std::optional<WrongAttribute> wrong_attribute(const Json& json) {
    if (!json.contains("wrong_attribute")) return std::nullopt;
    const Json& wrong = json.at("wrong_attribute");
    const std::string name = wrong.at("channel");
    const auto channel = std::ranges::find(attribute_channels, name, &AttributeChannel::name);
    if (channel == attribute_channels.end()) refuse("no channel is named \"" + name + "\"");
    return WrongAttribute{.channel = std::size_t(channel - attribute_channels.begin()),
                          .value = float(number(wrong.at("value"))),
                          .low = number(wrong.at("low")),
                          .truth = number(wrong.at("truth")),
                          .high = number(wrong.at("high")),
                          .error_over_bound = number(wrong.at("error_over_bound"))};
}

ReportedFinding reported(const Json& json) {
    return {.finding = {.x = whole_number<int>(json.at("x")),
                        .y = whole_number<int>(json.at("y")),
                        .verdict = class_named(json.at("class")),
                        .candidate = answer(json.at("candidate")),
                        .reference = answer(json.at("reference")),
                        .eps_px = number(json.at("eps_px")),
                        .candidate_depth = bound(json.at("candidate_depth_bound")),
                        .error_over_bound = number(json.at("error_over_bound")),
                        .wrong_attribute = wrong_attribute(json)},
            .explanation = json.at("explanation"),
            .command = json.at("command"),
            .waiver = json.value("waiver", "")};
}

ClassCounts counts_by_name(const Json& json) {
    ClassCounts counts{};
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] = count(json.at(std::string(name_of(PixelClass(i)))));
    return counts;
}

BoundRecord bound_record(const Json& json) {
    BoundRecord record{.max_error_over_bound = number(json.at("max_error_over_bound"))};
    if (!json.contains("histogram")) return record;
    const Json& bins = json.at("histogram");
    if (bins.size() != record.histogram.size())
        refuse("expected a histogram of " + std::to_string(record.histogram.size()) + " bins");
    for (std::size_t i = 0; i < record.histogram.size(); ++i) record.histogram[i] = count(bins.at(i));
    return record;
}

StageTimes stage_times(const Json& json) {
    return {.load = number(json.at("load")),
            .render = number(json.at("render")),
            .reference_build = number(json.at("reference_build")),
            .reference = number(json.at("reference")),
            .judge = number(json.at("judge")),
            .oracles = number(json.at("oracles")),
            .write = number(json.at("write"))};
}

Explanation explanation(const Json& json) {
    return {.name = json.at("name"),
            .description = json.at("description"),
            .explained = count(json.at("explained")),
            .asked = count(json.at("asked")),
            .contradicted = count(json.at("contradicted")),
            .checked = count(json.at("checked")),
            .look_at = json.value("look_at", ""),
            .saved_share = json.contains("spared") ? number(json.at("spared")) : 0};
}

/// null: none was made.
std::optional<Diagnosis> diagnosis(const Json& json) {
    if (json.is_null()) return std::nullopt;
    Diagnosis d{.defects = count(json.at("defects")), .cause = {}, .further = {}, .runners_up = {}};
    if (const Json& cause = json.at("cause"); !cause.is_null()) d.cause = explanation(cause);
    if (json.contains("further"))
        for (const Json& one : json.at("further")) d.further.push_back(explanation(one));
    for (const Json& one : json.at("runners_up")) d.runners_up.push_back(explanation(one));
    return d;
}

PictureDifferences picture(const Json& json) {
    PictureDifferences differences{};
    for (const auto& [name, d] : json.items())
        differences[std::size_t(class_named(name))] = {.pixels = count(d.at("pixels")),
                                                       .rms = number(d.at("rms")),
                                                       .mean = number(d.at("mean")),
                                                       .largest = number(d.at("largest"))};
    return differences;
}

SampledPixels sampled_pixels(const Json& json) {
    return {.stride = whole_number<int>(json.at("stride")),
            .first_x = whole_number<int>(json.at("first").at(0)),
            .first_y = whole_number<int>(json.at("first").at(1)),
            .pixels = count(json.at("pixels")),
            .seed = count(json.at("seed")),
            .fewer_because = json.at("fewer_because")};
}

OracleResult oracle_result(const Json& json) {
    OracleResult w{.name = json.at("name"), .absent = json.at("absent"), .worst = {}};
    if (!w.absent.empty()) return w;
    w.counts = counts_by_name(json.at("counts"));
    w.depth = bound_record(json.at("depth"));
    w.edges = bound_record(json.at("edges"));
    for (const Json& finding : json.at("worst")) w.worst.push_back(reported(finding));
    if (json.contains("sample")) w.sample = sampled_pixels(json.at("sample"));
    if (json.contains("picture")) w.picture = picture(json.at("picture"));
    if (json.contains("no_picture")) w.no_picture = json.at("no_picture");
    return w;
}

/// What waivers did, and what shards are put together by.
void read_gate(const Json& json, ViewResult& v) {
    for (const auto& [name, pixels] : json.at("waived").items())
        v.waived[std::size_t(class_named(name))] = count(pixels);
    for (const Json& one : json.at("waivers")) v.waivers.push_back(waiver_use_from(one));
    v.place = count(json.at("place"));
    if (json.contains("view_place")) v.view_place = count(json.at("view_place"));
    if (json.contains("scene_views")) v.scene_views = count(json.at("scene_views"));
    v.expects = json.value("expects", v.expects);
    v.scene_sha256 = json.at("scene_sha256");
}

/// Candidate, reference and the oracles that were compared have a row and a column each; none has where
/// nothing was judged.
void require_all_compared(const ViewResult& v) {
    const auto& same = v.id_agreement.same;
    const std::size_t frames = 2 + std::size_t(std::ranges::count(v.oracles, "", &OracleResult::absent));
    const auto has_all = [&](const std::vector<std::uint64_t>& row) { return row.size() == frames; };
    if (!same.empty() && (same.size() != frames || !std::ranges::all_of(same, has_all)))
        refuse("expected an id_agreement of " + std::to_string(frames) + " rows and columns");
}

void read_oracles(const Json& json, ViewResult& v) {
    for (const Json& one : json.at("oracles")) v.oracles.push_back(oracle_result(one));
    const Json& agreement = json.at("id_agreement");
    v.id_agreement.unanimous = count(agreement.at("unanimous"));
    for (const Json& row : agreement.at("same")) {
        v.id_agreement.same.emplace_back();
        for (const Json& pixels : row) v.id_agreement.same.back().push_back(count(pixels));
    }
    require_all_compared(v);
}

SceneSize scene_size(const Json& json) {
    return {count(json.at("triangles")), whole_number<int>(json.at("width")),
            whole_number<int>(json.at("height"))};
}

ShrunkView shrunk(const Json& json) {
    return {.file = json.at("file"),
            .before = scene_size(json.at("before")),
            .after = scene_size(json.at("after")),
            .tries = whole_number<int>(json.at("tries")),
            .command = json.at("command")};
}

ViewResult view(const Json& json) {
    ViewResult v{.scene = json.at("scene"),
                 .source = json.at("source"),
                 .view = json.at("view"),
                 .reason = json.at("reason"),
                 .outcome = outcome_named(json.at("outcome")),
                 .message = json.at("message"),
                 .width = whole_number<int>(json.at("width")),
                 .height = whole_number<int>(json.at("height")),
                 .triangles = count(json.at("triangles")),
                 .candidate = json.at("candidate"),
                 .reference = json.at("reference"),
                 .counts = counts_by_name(json.at("counts")),
                 .candidate_depth = bound_record(json.at("candidate_depth")),
                 .reference_depth = bound_record(json.at("reference_depth")),
                 .candidate_edges = bound_record(json.at("candidate_edges")),
                 .reference_edges = bound_record(json.at("reference_edges")),
                 .reference_defects = count(json.at("reference_defects")),
                 .adjudicated = count(json.at("adjudicated")),
                 .exact = count(json.at("exact")),
                 .diagnosis = diagnosis(json.at("diagnosis")),
                 .oracles = {},
                 .id_agreement = {},
                 .worst = {},
                 .notes = json.at("notes"),
                 .times = stage_times(json.at("times")),
                 .folder = json.at("folder")};
    for (const Json& finding : json.at("worst")) v.worst.push_back(reported(finding));
    read_oracles(json, v);
    read_gate(json, v);
    if (json.contains("shrunk")) v.shrunk = shrunk(json.at("shrunk"));
    return v;
}

void read_gate(const Json& root, Results& results) {
    const Json& run = root.at("run");
    results.argv = run.at("argv");
    const Json& shard = run.at("shard");
    results.shard = {.number = whole_number<int>(shard.at("number")),
                     .count = whole_number<int>(shard.at("count")),
                     .plan = shard.value("plan", ""),
                     .taken_from = shard.value("taken_from", "")};
    results.ending = ending_named(run.at("ending"));
    results.today = run.at("today");
    const Json& selection = root.at("selection");
    results.selection = {count(selection.at("scenes")), selection.at("sha256"), {}};
    if (const auto passed_over = selection.find("passed_over"); passed_over != selection.end())
        for (const auto& [ending, files] : passed_over->items())
            results.selection.passed_over[ending] = count(files);
    const Json& waivers = root.at("waivers");
    results.strictness = waivers.at("strict") ? Strictness::strict : Strictness::lenient;
    for (const Json& one : waivers.at("list")) results.waivers.push_back(waiver_from(one));
}

void require_known_version(const std::string& version) {
    const std::string ours = Results::schema_version;
    const std::string major = ours.substr(0, ours.find('.') + 1);
    if (!version.starts_with(major))
        refuse("schema_version is " + version + ", this zproof reads " + major +
               "x; use the zproof that wrote it");
}

/// `views`: those that are no longer in `root`.
Results results_from(const Json& root, std::vector<ViewResult> views) {
    require_known_version(root.at("schema_version"));
    const Json& run = root.at("run");
    Results results{.version = run.at("version"),
                    .commit = run.value("commit", ""),
                    .command = run.at("command"),
                    .compiler = run.at("compiler"),
                    .embree = run.at("embree"),
                    .threads = whole_number<int>(run.at("threads")),
                    .isa = run.value("isa", ""),
                    .renderers = {},
                    .views = std::move(views)};
    for (const Json& one : run.at("renderers"))
        results.renderers.push_back({.name = one.at("name"),
                                     .version = one.at("version"),
                                     .precision = one.at("precision").dump(),
                                     .ids = one.value("ids", "triangle")});
    read_gate(root, results);
    for (const Json& one : root.at("views")) results.views.push_back(view(one));
    return results;
}

/// What is wrong with view number `i`, and where.
std::string fault_in_view(const Json::exception& e, std::size_t i) {
    const std::string fault = json_fault(e), place = "(/views/" + std::to_string(i);
    return place + (fault.starts_with("(/") ? fault.substr(1) : ") " + fault);
}

/// Takes each view from the parser as soon as it is read: all of them as JSON would take many times the room.
class ViewReader {
  public:
    /// The parser's callback; false: the parser forgets what it has read.
    bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
        if (depth == 1 && event == Json::parse_event_t::key) key_ = parsed;
        if (depth == 1 && event == Json::parse_event_t::value && key_ == "schema_version")
            require_known_version(parsed);
        if (depth != 2 || event != Json::parse_event_t::object_end || key_ != "views") return true;
        take(Json(std::move(parsed)));  // without the parser's array around it, which is always at 0
        return false;
    }

    std::vector<ViewResult> views;

  private:
    void take(const Json& one) {
        try {
            views.push_back(view(one));
        } catch (const Json::exception& e) {
            refuse(fault_in_view(e, views.size()));
        }
    }

    std::string key_;  ///< of the root, that the parser is at
};

}  // namespace

Results results_from_json(const std::string& text) try {
    ViewReader reader;
    const Json root = Json::parse(text, std::ref(reader));
    return results_from(root, std::move(reader.views));
} catch (const Json::exception& e) {
    refuse(json_fault(e));
}

Results results_from_message_pack(const std::string& bytes) try {
    return results_from(Json::from_msgpack(bytes), {});
} catch (const Json::exception& e) {
    refuse(json_fault(e));
}

}  // namespace zproof
