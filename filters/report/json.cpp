#include "filters/report/json.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/result_file.h"
#include "reports/whole_number.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;
using namespace study;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(shortest(value)); }

double number(const Json& json) {
    if (json.is_number()) return json.get<double>();
    const std::string text = json.get<std::string>();
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
    if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
    throw ReportError{"filters.json: expected a number, \"nan\", \"inf\" or \"-inf\", found \"" + text +
                      "\""};
}

Json json_of(const RegionScore& score, const std::vector<MetricCard>& metrics) {
    Json json{{"region", score.region}, {"pixels", score.pixels}};
    if (score.pixels == 0) return json;
    json["truth_half_width"] = number(score.truth_half_width);
    for (std::size_t i = 0; i < metrics.size(); ++i) json[metrics[i].name] = number(score.values.at(i));
    return json;
}

Json json_of(const Cost& cost) {
    return {{"pixels", cost.pixels},
            {"texels", number(cost.texels)},
            {"lines", number(cost.lines)},
            {"bytes_stored", cost.bytes_stored},
            {"build_ms", number(cost.build_ms)},
            {"ns_per_sample", number(cost.ns_per_sample)}};
}

Json json_of(const MethodScore& method, const std::vector<MetricCard>& metrics) {
    Json regions = Json::array();
    for (const RegionScore& score : method.regions) regions.push_back(json_of(score, metrics));
    Json json{{"method", method.label},
              {"file", method.file},
              {"cost", json_of(method.cost)},
              {"flicker",
               {{"rms", number(method.flicker.rms)},
                {"ratio", number(method.flicker.ratio)},
                {"steps", method.flicker.steps}}},
              {"regions", regions}};
    if (method.claim)
        json["claim"] = {{"method", method.claim->method},
                         {"promise", method.claim->promise},
                         {"pixels_outside", method.claim->pixels_outside}};
    return json;
}

Json json_of(const ViewStudy& view, const std::vector<MetricCard>& metrics) {
    Json methods = Json::array(), missing = Json::array();
    for (const MissingPicture& one : view.missing)
        missing.push_back({{"method", one.label}, {"reason", one.reason}});
    for (const MethodScore& method : view.methods) methods.push_back(json_of(method, metrics));
    return {{"scene", view.scene},           {"view", view.view},
            {"reason", view.reason},         {"width", view.width},
            {"height", view.height},         {"first_row", view.first_row},
            {"textures", view.textures},     {"scene_sha256", view.scene_sha256},
            {"truth_file", view.truth_file}, {"truth_seconds", number(view.truth_seconds)},
            {"missing_pictures", missing},   {"methods", methods}};
}

Json cards_of(const StudyResults& results) {
    Json metrics = Json::array(), regions = Json::array(), methods = Json::array();
    for (const MetricCard& m : results.metrics)
        metrics.push_back({{"name", m.name},
                           {"definition", m.definition},
                           {"source", m.source},
                           {"higher_is_better", m.higher_is_better},
                           {"decimals", m.decimals}});
    for (const RegionCard& r : results.regions)
        regions.push_back({{"name", r.name}, {"definition", r.definition}});
    for (const MethodCard& m : results.methods)
        methods.push_back({{"label", m.label},
                           {"footprint", m.footprint},
                           {"lod", m.lod},
                           {"taps", m.taps},
                           {"source", m.source}});
    return {{"metrics", metrics}, {"regions", regions}, {"methods", methods}};
}

RegionScore region_score(const Json& json, const std::vector<MetricCard>& metrics) {
    RegionScore score{json.at("region"), whole_number<std::uint64_t>(json.at("pixels")), 0, {}};
    if (score.pixels == 0) {
        score.values.assign(metrics.size(), std::numeric_limits<double>::quiet_NaN());
        return score;
    }
    score.truth_half_width = number(json.at("truth_half_width"));
    for (const MetricCard& metric : metrics) score.values.push_back(number(json.at(metric.name)));
    return score;
}

MethodScore method_score(const Json& json, const std::vector<MetricCard>& metrics) {
    const Json &cost = json.at("cost"), &flicker = json.at("flicker");
    MethodScore method{.label = json.at("method"),
                       .regions = {},
                       .cost = {.texels = number(cost.at("texels")),
                                .lines = number(cost.at("lines")),
                                .bytes_stored = whole_number<std::uint64_t>(cost.at("bytes_stored")),
                                .build_ms = number(cost.at("build_ms")),
                                .ns_per_sample = number(cost.at("ns_per_sample")),
                                .pixels = whole_number<std::uint64_t>(cost.at("pixels"))},
                       .flicker = {number(flicker.at("rms")), number(flicker.at("ratio")),
                                   whole_number<int>(flicker.at("steps"))},
                       .file = json.at("file")};
    for (const Json& one : json.at("regions")) method.regions.push_back(region_score(one, metrics));
    if (json.contains("claim")) {
        const Json& claim = json.at("claim");
        method.claim = {claim.at("method"), claim.at("promise"),
                        whole_number<std::uint64_t>(claim.at("pixels_outside"))};
    }
    return method;
}

ViewStudy view_study(const Json& json, const std::vector<MetricCard>& metrics) {
    ViewStudy view{.scene = json.at("scene"),
                   .view = json.at("view"),
                   .reason = json.at("reason"),
                   .width = whole_number<int>(json.at("width")),
                   .height = whole_number<int>(json.at("height")),
                   .first_row = whole_number<int>(json.at("first_row")),
                   .textures = json.at("textures"),
                   .methods = {},
                   .scene_sha256 = json.value("scene_sha256", ""),
                   .truth_file = json.at("truth_file"),
                   .truth_seconds = number(json.at("truth_seconds"))};
    for (const Json& one : json.at("methods")) view.methods.push_back(method_score(one, metrics));
    for (const Json& one : json.value("missing_pictures", Json::array()))
        view.missing.push_back({one.at("method"), one.at("reason")});
    return view;
}

void read_cards(const Json& json, StudyResults& results) {
    for (const Json& m : json.at("metrics"))
        results.metrics.push_back({m.at("name"), m.at("definition"), m.at("source"), m.at("higher_is_better"),
                                   whole_number<int>(m.at("decimals"))});
    for (const Json& r : json.at("regions")) results.regions.push_back({r.at("name"), r.at("definition")});
    for (const Json& m : json.at("methods"))
        results.methods.push_back(
            {m.at("label"), m.at("footprint"), m.at("lod"), m.at("taps"), m.at("source")});
}

}  // namespace

std::string filters_json(const StudyResults& results) {
    Json views = Json::array();
    for (const ViewStudy& view : results.views) views.push_back(json_of(view, results.metrics));
    const Json whole{{"schema_version", StudyResults::schema_version},
                     {"version", results.version},
                     {"commit", results.commit},
                     {"command", results.command},
                     {"compiler", results.compiler},
                     {"processor", results.processor},
                     {"date", results.date},
                     {"truth", results.truth},
                     {"threads", results.threads},
                     {"seconds", number(results.seconds)},
                     {"is_complete", results.is_complete},
                     {"cards", cards_of(results)},
                     {"views", views}};
    return whole.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

StudyResults filters_from_json(const std::string& text) try {
    const Json json = Json::parse(text);
    const std::string version = json.at("schema_version");
    if (!version.starts_with("1."))
        throw ReportError{"filters.json: schema_version is " + version +
                          ", this zproof reads 1.x; use the zproof that wrote it"};
    StudyResults results;
    results.version = json.at("version"), results.command = json.at("command");
    results.commit = json.value("commit", ""), results.processor = json.value("processor", "");
    results.date = json.value("date", "");
    results.compiler = json.at("compiler"), results.truth = json.at("truth");
    results.threads = whole_number<int>(json.at("threads")), results.seconds = number(json.at("seconds"));
    results.is_complete = json.at("is_complete");
    read_cards(json.at("cards"), results);
    for (const Json& one : json.at("views")) results.views.push_back(view_study(one, results.metrics));
    return results;
} catch (const Json::exception& e) {
    throw ReportError{"filters.json: " + json_fault(e)};
}

}  // namespace zproof
