#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "reports/json.h"
#include "reports/waiver_json.h"
#include "reports/waiver_status.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(shortest(value)); }

/// The double whose shortest decimal is the float's.
Json number(float value) {
    const std::string text = shortest(value);
    double same = 0;
    std::from_chars(text.data(), text.data() + text.size(), same);
    return number(same);
}

Json id(PrimitiveId primitive) {
    return primitive == PrimitiveId::none ? Json(nullptr) : Json(static_cast<std::uint32_t>(primitive));
}

Json answer(const Answer& a) {
    return {{"primitive", id(a.primitive)},
            {"camera_depth", number(a.camera_depth)},
            {"camera_depth_bits", hex_bits(a.camera_depth)}};
}

Json bound(const DepthBound& b) {
    return {{"low", number(b.low)}, {"truth", number(b.truth)}, {"high", number(b.high)}};
}

Json wrong_attribute(const WrongAttribute& wrong) {
    return {{"channel", attribute_channels[wrong.channel].name},
            {"value", number(wrong.value)},
            {"low", number(wrong.low)},
            {"truth", number(wrong.truth)},
            {"high", number(wrong.high)},
            {"error_over_bound", number(wrong.error_over_bound)}};
}

Json reported(const ReportedFinding& r) {
    const Finding& f = r.finding;
    Json object = {{"x", f.x},
                   {"y", f.y},
                   {"class", name_of(f.verdict)},
                   {"candidate", answer(f.candidate)},
                   {"reference", answer(f.reference)},
                   {"eps_px", number(f.eps_px)},
                   {"candidate_depth_bound", bound(f.candidate_depth)},
                   {"error_over_bound", number(f.error_over_bound)},
                   {"explanation", r.explanation},
                   {"command", r.command}};
    if (!r.waiver.empty()) object["waiver"] = r.waiver;
    if (f.wrong_attribute) object["wrong_attribute"] = wrong_attribute(*f.wrong_attribute);
    return object;
}

Json reported(const std::vector<ReportedFinding>& findings) {
    Json list = Json::array();
    for (const ReportedFinding& finding : findings) list.push_back(reported(finding));
    return list;
}

Json counts_by_name(const ClassCounts& counts) {
    Json object = Json::object();
    for (std::size_t i = 0; i < counts.size(); ++i) object[std::string(name_of(PixelClass(i)))] = counts[i];
    return object;
}

/// The record has no histogram where nothing was counted.
Json bound_record(const BoundRecord& record) {
    Json object = {{"max_error_over_bound", number(record.max_error_over_bound)}};
    if (record.histogram != BoundHistogram{}) object["histogram"] = record.histogram;
    return object;
}

Json stage_times(const StageTimes& t) {
    return {{"load", number(t.load)},
            {"render", number(t.render)},
            {"reference_build", number(t.reference_build)},
            {"reference", number(t.reference)},
            {"judge", number(t.judge)},
            {"oracles", number(t.oracles)},
            {"write", number(t.write)}};
}

Json explanation(const Explanation& e) {
    return {{"name", e.name},       {"description", e.description},
            {"look_at", e.look_at}, {"explained", e.explained},
            {"asked", e.asked},     {"contradicted", e.contradicted},
            {"checked", e.checked}, {"spared", number(e.saved_share)}};
}

Json diagnosis(const std::optional<Diagnosis>& d) {
    if (!d) return nullptr;
    Json further = Json::array(), runners_up = Json::array();
    for (const Explanation& e : d->further) further.push_back(explanation(e));
    for (const Explanation& e : d->runners_up) runners_up.push_back(explanation(e));
    return {{"defects", d->defects},
            {"cause", d->cause ? explanation(*d->cause) : Json(nullptr)},
            {"further", further},
            {"runners_up", runners_up}};
}

/// Classes without a pixel are left out.
Json picture(const PictureDifferences& differences) {
    Json object = Json::object();
    for (std::size_t i = 0; i < differences.size(); ++i)
        if (const PictureDifference& d = differences[i]; d.pixels > 0)
            object[std::string(name_of(PixelClass(i)))] = {{"pixels", d.pixels},
                                                           {"rms", number(d.rms)},
                                                           {"mean", number(d.mean)},
                                                           {"largest", number(d.largest)}};
    return object;
}

Json oracle_result(const OracleResult& w) {
    Json object = {{"name", w.name}, {"absent", w.absent}};
    if (!w.absent.empty()) return object;
    object.update({{"defects", defect_count(w.counts)},
                   {"counts", counts_by_name(w.counts)},
                   {"depth", bound_record(w.depth)},
                   {"edges", bound_record(w.edges)},
                   {"worst", reported(w.worst)}});
    if (w.sample)
        object["sample"] = {{"pixels", w.sample->pixels},
                            {"stride", w.sample->stride},
                            {"first", {w.sample->first_x, w.sample->first_y}},
                            {"seed", w.sample->seed},
                            {"fewer_because", w.sample->fewer_because}};
    if (w.picture) object["picture"] = picture(*w.picture);
    if (!w.no_picture.empty()) object["no_picture"] = w.no_picture;
    return object;
}

Json oracles(const std::vector<OracleResult>& compared) {
    Json list = Json::array();
    for (const OracleResult& w : compared) list.push_back(oracle_result(w));
    return list;
}

/// Classes without a pixel are left out.
Json waived_by_name(const ClassCounts& counts) {
    Json object = Json::object();
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0) object[std::string(name_of(PixelClass(i)))] = counts[i];
    return object;
}

Json waiver_uses(const std::vector<WaiverUse>& uses) {
    Json list = Json::array();
    for (const WaiverUse& use : uses) list.push_back(waiver_use_object(use));
    return list;
}

Json scene_size(const SceneSize& size) {
    return {{"triangles", size.triangles}, {"width", size.width}, {"height", size.height}};
}

Json shrunk(const ShrunkView& shrunk) {
    return {{"file", shrunk.file},
            {"before", scene_size(shrunk.before)},
            {"after", scene_size(shrunk.after)},
            {"tries", shrunk.tries},
            {"command", shrunk.command}};
}

Json view_object(const ViewResult& v) {
    Json object = {{"scene", v.scene},
                   {"source", v.source},
                   {"view", v.view},
                   {"reason", v.reason},
                   {"outcome", name_of(v.outcome)},
                   {"message", v.message},
                   {"width", v.width},
                   {"height", v.height},
                   {"triangles", v.triangles},
                   {"candidate", v.candidate},
                   {"reference", v.reference},
                   {"defects", defect_count(v)},
                   {"counts", counts_by_name(v.counts)},
                   {"waived", waived_by_name(v.waived)},
                   {"waivers", waiver_uses(v.waivers)},
                   {"candidate_depth", bound_record(v.candidate_depth)},
                   {"reference_depth", bound_record(v.reference_depth)},
                   {"candidate_edges", bound_record(v.candidate_edges)},
                   {"reference_edges", bound_record(v.reference_edges)},
                   {"reference_defects", v.reference_defects},
                   {"adjudicated", v.adjudicated},
                   {"exact", v.exact},
                   {"diagnosis", diagnosis(v.diagnosis)},
                   {"oracles", oracles(v.oracles)},
                   {"id_agreement", {{"same", v.id_agreement.same}, {"unanimous", v.id_agreement.unanimous}}},
                   {"worst", reported(v.worst)},
                   {"notes", v.notes},
                   {"folder", v.folder},
                   {"place", v.place},
                   {"view_place", v.view_place},
                   {"scene_views", v.scene_views},
                   {"scene_sha256", v.scene_sha256},
                   {"times", stage_times(v.times)}};
    if (!v.expects.empty()) object["expects"] = v.expects;
    if (v.shrunk) object["shrunk"] = shrunk(*v.shrunk);
    return object;
}

Json renderers(const std::vector<RendererFacts>& all) {
    Json list = Json::array();
    for (const RendererFacts& r : all)
        list.push_back({{"name", r.name},
                        {"version", r.version},
                        {"precision", Json::parse(r.precision)},
                        {"ids", r.ids}});
    return list;
}

Json shard_object(const Shard& shard) {
    Json object{{"number", shard.number}, {"count", shard.count}};
    if (!shard.plan.empty()) object["plan"] = shard.plan;
    if (!shard.taken_from.empty()) object["taken_from"] = shard.taken_from;
    return object;
}

Json run_object(const Results& r) {
    return {{"version", r.version},
            {"commit", r.commit},
            {"command", r.command},
            {"argv", r.argv},
            {"compiler", r.compiler},
            {"embree", r.embree},
            {"threads", r.threads},
            {"isa", r.isa},
            {"shard", shard_object(r.shard)},
            {"ending", name_of(r.ending)},
            {"today", r.today},
            {"renderers", renderers(r.renderers)}};
}

Json waivers(const Results& r) {
    Json list = Json::array();
    for (const WaiverStatus& status : waiver_statuses(r)) {
        Json object = waiver_object(*status.waiver);
        object["state"] = name_of(status.state);
        list.push_back(std::move(object));
    }
    return {{"strict", r.strictness == Strictness::strict}, {"list", list}};
}

Json summary_object(const Results& results) {
    Json summary = {{"views", results.views.size()}};
    for (const Outcome outcome : all_outcomes)
        summary[std::string(name_of(outcome))] =
            std::ranges::count(results.views, outcome, &ViewResult::outcome);
    return summary;
}

/// All of it, with those views.
Json root_object(const Results& results, Json views) {
    return {{"schema_version", Results::schema_version},
            {"run", run_object(results)},
            {"selection",
             {{"scenes", results.selection.scenes},
              {"sha256", results.selection.sha256},
              {"passed_over", results.selection.passed_over}}},
            {"summary", summary_object(results)},
            {"waivers", waivers(results)},
            {"views", std::move(views)}};
}

std::string text_of(const Json& value) { return value.dump(1, ' ', false, Json::error_handler_t::replace); }

/// A view as an element of the root's last array: its lines stand two steps further in. A line break stands
/// between tokens only.
std::string element_text(const ViewResult& view) {
    std::string text = "\n  ";
    for (const char c : text_of(view_object(view))) {
        text += c;
        if (c == '\n') text += "  ";
    }
    return text;
}

}  // namespace

void write_json(const TextSink& out, const Results& results) {
    constexpr std::string_view end = "]\n}";
    std::string text = text_of(root_object(results, Json::array()));
    text.resize(text.size() - end.size());
    out(text);
    for (const ViewResult& view : results.views)
        out((&view == results.views.data() ? "" : ",") + element_text(view));
    out((results.views.empty() ? "" : "\n ") + std::string{end} + "\n");
}

std::string to_json(const Results& results) {
    return collected([&](const TextSink& out) { write_json(out, results); });
}

std::string to_message_pack(const Results& results) {
    std::string bytes;
    Json views = Json::array();
    for (const ViewResult& view : results.views) views.push_back(view_object(view));
    Json::to_msgpack(root_object(results, std::move(views)), bytes);
    return bytes;
}

}  // namespace zproof
