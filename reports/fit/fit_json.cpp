#include <cmath>
#include <nlohmann/json.hpp>

#include "frame/precision_text.h"
#include "reports/fit/fit_report.h"
#include "reports/fit/fit_words.h"

namespace zproof {
namespace {

using Json = nlohmann::ordered_json;

/// The version of the file's shape; a new key is a minor step.
constexpr const char* schema_version = "1.0";

Json json_of(const PixelCoord& p) { return {p.x, p.y}; }

Json json_of(const measure::LeastEps& eps) {
    Json pixels = Json::array();
    for (const PixelCoord& p : eps.decided_by) pixels.push_back(json_of(p));
    return {{"low_px", eps.px.low}, {"high_px", eps.found_px()}, {"decided_by", pixels}};
}

Json json_of(const measure::LeastDepth& depth) {
    return {{"relative", depth.error.relative},
            {"ulps", depth.error.ulps},
            {"of_range", depth.error.of_range},
            {"decided_by", json_of(depth.decided_by)}};
}

Json json_of(const measure::OctaveCounts& counts) {
    Json curve = Json::array();
    for (int octave = measure::least_octave; octave <= measure::most_octave; ++octave)
        curve.push_back({{"error", std::ldexp(1.0, octave)}, {"not_explained", counts.above(octave)}});
    return curve;
}

Json json_of(const std::vector<measure::LeftOut>& left_out) {
    Json pixels = Json::array();
    for (const measure::LeftOut& l : left_out)
        pixels.push_back({{"pixel", json_of(l.pixel)},
                          {"id", std::uint32_t(l.answer.primitive)},
                          {"why", name_of(l.reason)}});
    return pixels;
}

Json json_of(const std::vector<measure::DepthBeside>& trade) {
    Json all = Json::array();
    for (const measure::DepthBeside& beside : trade)
        all.push_back({{"eps_px", beside.eps_px},
                       {"relative", beside.error.relative},
                       {"ulps", beside.error.ulps},
                       {"of_range", beside.error.of_range}});
    return all;
}

Json json_of(const FittedView& view) {
    const measure::ViewFit& fit = view.fit;
    return {{"scene", view.scene},
            {"view", view.view},
            {"pixels", fit.pixels},
            {"eps", json_of(fit.eps)},
            {"depth", json_of(fit.depth)},
            {"trade", json_of(fit.trade)},
            {"seams", fit.seams},
            {"gaps", fit.gaps},
            {"eps_curve", json_of(fit.eps_px)},
            {"depth_curve", json_of(fit.depth_relative)},
            {"eps_of_alone", json_of(fit.eps_of_alone)},
            {"depth_of_alone", json_of(fit.depth_of_alone)},
            {"left_out", json_of(fit.left_out)},
            {"promise", Json::parse(precision_to_json(fit.promise))},
            {"defects", fit.defects},
            {"verified", fit.is_verified}};
}

}  // namespace

std::string fit_json(const std::string& renderer, const std::vector<FittedView>& views) {
    Json all = Json::array();
    for (const FittedView& view : views) all.push_back(json_of(view));
    const Json whole{{"schema_version", schema_version},
                     {"renderer", renderer},
                     {"promise", Json::parse(precision_to_json(promise_of(views)))},
                     {"explains_all", explains_all(views)},
                     {"views", all}};
    return whole.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace zproof
