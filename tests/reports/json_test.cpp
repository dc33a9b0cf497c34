#include "reports/json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "tests/reports/results_schema.h"
#include "tests/reports/sample.h"
#include "tests/reports/waived_run.h"

namespace zproof {

namespace {

using Json = nlohmann::json;

/// The shipped schema, closed: keys that it does not name are errors, so that it must name all that we write.
Json closed(Json schema) {
    if (schema.is_object() && schema.contains("properties")) schema["additionalProperties"] = false;
    if (schema.is_structured())
        for (Json& part : schema) part = closed(part);
    return schema;
}

/// What the schema has against a document; empty where it is content.
std::string objections(const Json& document) {
    const Json schema_text = closed(Json::parse(content_of(ZPROOF_RESULTS_SCHEMA)));
    valijson::Schema schema;
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_text), schema);
    valijson::ValidationResults results;
    valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
    std::string text;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
        for (const std::string& step : error.context) text += step;
        text += ": " + error.description + "\n";
    }
    return text;
}

std::string refusal(const std::string& text) {
    try {
        results_from_json(text);
    } catch (const ReportError& e) {
        return e.what();
    }
    return "nothing was refused";
}

}  // namespace

TEST(Json, SchemaIsTheOneOfTheFields) {
    EXPECT_EQ(content_of(ZPROOF_RESULTS_SCHEMA), results_schema())
        << "renew it: build/release/tests/reports/write_schema > reports/results.schema.json";
}

TEST(Json, OfARunWithWaiversFitsTheSchema) { EXPECT_EQ(objections(Json::parse(to_json(waived_run()))), ""); }

TEST(Json, ReadsBackToTheSameResults) {
    const std::string text = to_json(sample_results());
    EXPECT_EQ(to_json(results_from_json(text)), text);
}

TEST(Json, HasTheBytesOfOneDocumentThoughItIsPutOutViewByView) {
    Results results = sample_results();
    for (const std::size_t count : {4u, 1u, 0u}) {
        results.views.resize(count);
        std::vector<std::string> pieces;
        write_json([&](std::string_view piece) { pieces.emplace_back(piece); }, results);
        EXPECT_EQ(pieces.size(), count + 2) << "what stands before the views, each view, and the end";
        const std::string text = to_json(results);
        EXPECT_EQ(std::accumulate(pieces.begin(), pieces.end(), std::string{}), text);
        EXPECT_EQ(nlohmann::ordered_json::parse(text).dump(1) + "\n", text);
    }
}

TEST(Json, KeepsAWrongAttribute) {
    Results original = sample_results();
    original.views[1].worst[1].finding.wrong_attribute = WrongAttribute{
        .channel = 3, .value = 0.1f, .low = 0.25, .truth = 0.5, .high = 0.75, .error_over_bound = 1.6};
    const std::string text = to_json(original);
    EXPECT_EQ(objections(Json::parse(text)), "");
    EXPECT_EQ(to_json(results_from_json(text)), text);
    EXPECT_EQ(Json::parse(text).at("/views/1/worst/1/wrong_attribute/channel"_json_pointer), "uv.v");
    const auto back = results_from_json(text).views[1].worst[1].finding.wrong_attribute;
    ASSERT_TRUE(back);
    EXPECT_EQ(back->value, 0.1f);
    EXPECT_EQ(back->high, 0.75);
}

TEST(Json, KeepsWhatAViewWasShrunkTo) {
    Results original = sample_results();
    original.views[1].shrunk = {.file = "shrunk/a.view.json",
                                .before = {.triangles = 500, .width = 64, .height = 48},
                                .after = {.triangles = 2, .width = 1, .height = 3},
                                .tries = 113,
                                .command = "zproof explain shrunk/a.view.json 0 2"};
    const std::string text = to_json(original);
    EXPECT_EQ(objections(Json::parse(text)), "");
    EXPECT_EQ(to_json(results_from_json(text)), text);
    const auto back = results_from_json(text).views[1].shrunk;
    ASSERT_TRUE(back);
    EXPECT_EQ(back->before.triangles, 500u);
    EXPECT_EQ(back->after.height, 3);
    EXPECT_EQ(back->tries, 113);
}

TEST(Json, KeepsEveryBitOfHardNumbers) {
    const Results original = sample_results();
    const Results back = results_from_json(to_json(original));
    ASSERT_EQ(back.views.size(), 4u);
    const ViewResult& room = back.views[1];
    EXPECT_EQ(room.worst[0].finding.reference.primitive, PrimitiveId(0xFFFF'FFFE));
    EXPECT_EQ(room.worst[1].finding.reference.primitive, PrimitiveId((1u << 24) + 1));
    EXPECT_EQ(room.worst[0].finding.candidate.primitive, PrimitiveId::none);
    EXPECT_EQ(room.worst[0].finding.candidate.camera_depth, background_depth);
    EXPECT_EQ(room.worst[1].finding.eps_px, std::nextafter(0.1, 1.0));
    EXPECT_EQ(std::bit_cast<std::uint32_t>(room.worst[1].finding.reference.camera_depth),
              std::bit_cast<std::uint32_t>(original.views[1].worst[1].finding.reference.camera_depth));
    EXPECT_TRUE(std::isnan(room.worst[0].finding.error_over_bound));
    EXPECT_TRUE(std::isinf(room.candidate_depth.max_error_over_bound));
    EXPECT_EQ(room.counts, original.views[1].counts);
    EXPECT_EQ(room.candidate_depth.histogram, original.views[1].candidate_depth.histogram);
    EXPECT_EQ(room.candidate_edges.histogram, original.views[1].candidate_edges.histogram);
    EXPECT_EQ(room.reference_edges.max_error_over_bound, 0.25);
    EXPECT_EQ(room.diagnosis->cause->name, "a row is <lost>");
    EXPECT_EQ(room.diagnosis->runners_up.at(0).checked, 1000u);
    EXPECT_EQ(room.diagnosis->further.at(0).fitted, "1 of <16>");
    EXPECT_FALSE(back.views[0].diagnosis);
    EXPECT_EQ(back.views[2].scene, hostile_name);
    EXPECT_EQ(back.views[3].outcome, Outcome::not_judged);
}

TEST(Json, TellsTheCausesOfTheRunAndWhetherTheyWereSought) {
    Results results = sample_results();
    results.diagnosis = CauseSearch::left_out;
    results.views[1].diagnosis->cause->saved_bits = 56;
    const Json root = Json::parse(to_json(results));
    EXPECT_EQ(root.at("/causes/0/name"_json_pointer), "a row is <lost>");
    EXPECT_EQ(root.at("/causes/0/views"_json_pointer), 1);
    EXPECT_EQ(root.at("/causes/0/spared_bits"_json_pointer), 56);
    EXPECT_EQ(root.at("/run/diagnosis"_json_pointer), false);
    const Results back = results_from_json(to_json(results));
    EXPECT_EQ(back.diagnosis, CauseSearch::left_out);
    EXPECT_EQ(back.views[1].diagnosis->cause->saved_bits, 56);
}

TEST(Json, HasAHistogramOnlyWhereSomethingWasCounted) {
    const Json view = Json::parse(to_json(sample_results())).at("/views/0"_json_pointer);
    EXPECT_EQ(view.at("candidate_depth").at("histogram").at(0), 1'234'567);
    EXPECT_FALSE(view.at("reference_depth").contains("histogram"));
    const Results back = results_from_json(to_json(sample_results()));
    EXPECT_EQ(back.views[0].reference_depth, BoundRecord{});
}

TEST(Json, WritesDepthsAsShortestNumberAndBits) {
    const Json answer = Json::parse(to_json(sample_results())).at("/views/1/worst/0/reference"_json_pointer);
    EXPECT_EQ(answer.at("camera_depth").dump(), "0.1");
    EXPECT_EQ(answer.at("camera_depth_bits"), "0x3dcccccd");
}

TEST(Json, IsWhatTheSchemaSays) { EXPECT_EQ(objections(Json::parse(to_json(sample_results()))), ""); }

TEST(Json, OfAnEmptyRunIsWhatTheSchemaSays) { EXPECT_EQ(objections(Json::parse(to_json({}))), ""); }

TEST(Json, SchemaObjectsToWhatIsMissingOrUnknown) {
    Json document = Json::parse(to_json(sample_results()));
    document["views"][0].erase("counts");
    EXPECT_NE(objections(document), "");
    document = Json::parse(to_json(sample_results()));
    document["views"][0]["times"]["coffee"] = 1;
    EXPECT_NE(objections(document), "");
}

TEST(Json, RunsDifferInRunAndTimesOnly) {
    Results other = sample_results();
    other.threads = 64;
    other.command = "zproof run -j 64";
    for (ViewResult& view : other.views) view.times = {.load = 9, .judge = 1.0 / 3};
    Json a = Json::parse(to_json(sample_results())), b = Json::parse(to_json(other));
    EXPECT_NE(a, b);
    for (Json* document : {&a, &b}) {
        document->erase("run");
        for (Json& view : (*document)["views"]) view.erase("times");
    }
    EXPECT_EQ(a, b);
}

TEST(Json, RefusesResultsOfAnotherMajorVersion) {
    Json document = Json::parse(to_json(sample_results()));
    document["schema_version"] = "1.4";
    EXPECT_NE(refusal(document.dump()).find("this zproof reads 2.x"), std::string::npos);
}

TEST(Json, PassesOverUnknownKeys) {
    Json document = Json::parse(to_json(sample_results()));
    document["schema_version"] = "2.7";
    document["views"][0]["mood"] = "calm";
    EXPECT_EQ(to_json(results_from_json(document.dump())), to_json(sample_results()));
}

TEST(Json, RefusalNamesThePlace) {
    Json document = Json::parse(to_json(sample_results()));
    document["views"][1]["counts"].erase("hole");
    EXPECT_NE(refusal(document.dump()).find("/views/1/counts"), std::string::npos)
        << refusal(document.dump());
    EXPECT_NE(refusal(document.dump()).find("hole"), std::string::npos);
}

TEST(Json, RefusesWhatItCannotMean) {
    const std::string text = to_json(sample_results());
    const auto changed = [&](const std::string& pointer, const Json& value) {
        Json document = Json::parse(text);
        document[Json::json_pointer(pointer)] = value;
        return refusal(document.dump());
    };
    EXPECT_NE(refusal("{").find("results.json"), std::string::npos);
    EXPECT_NE(changed("/schema_version", "3.0").find("3.0"), std::string::npos);
    EXPECT_NE(changed("/views/0/outcome", "fine").find("fine"), std::string::npos);
    EXPECT_NE(changed("/views/0/triangles", -1).find("-1"), std::string::npos);
    EXPECT_NE(changed("/views/1/worst/0/class", "holes").find("holes"), std::string::npos);
    EXPECT_NE(changed("/views/1/worst/0/reference/camera_depth_bits", "0x12").find("0x12"),
              std::string::npos);
    EXPECT_NE(changed("/views/0/candidate_depth/histogram", Json::array({1})).find("21"), std::string::npos);
    EXPECT_NE(changed("/views/0/id_agreement/same", {{1}}).find("rows and columns"), std::string::npos);
    EXPECT_NE(changed("/views/0/id_agreement/same", {{1}, {1}}).find("rows and columns"), std::string::npos);
}

/// Of no use to the reader: sums of what stands elsewhere, and a declaration, which it keeps as text.
bool is_passed_over(const std::string& place) {
    const auto has = [&](const char* part) { return place.find(part) != std::string::npos; };
    return has("/precision/") || place.starts_with("/summary/") || place.starts_with("/causes/") ||
           (place.ends_with("/defects") && !has("/diagnosis/"));
}

TEST(Json, RefusesWholeNumbersThatDoNotFit) {
    int places = 0;
    for (const Results& results : {sample_results(), waived_run()}) {
        const Json document = Json::parse(to_json(results)), leaves = document.flatten();
        for (const auto& [place, value] : leaves.items()) {
            if (!value.is_number_integer() || is_passed_over(place)) continue;
            ++places;
            for (const Json& large : {Json(1e308), Json(1.5), Json(-9223372036854775807)}) {
                Json other = document;
                other[Json::json_pointer(place)] = large;
                EXPECT_NE(refusal(other.dump()).find("(" + place + ") expected a whole number"),
                          std::string::npos)
                    << place << " " << large << ": " << refusal(other.dump());
            }
        }
    }
    EXPECT_GT(places, 100);
}

TEST(Json, SurvivesNamesThatAreNoText) {
    Results results = sample_results();
    results.views[0].scene = "\xFF\xFE";
    EXPECT_EQ(results_from_json(to_json(results)).views[0].scene, "\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(MessagePack, KeepsAllThatJsonKeepsAndBytesThatAreNoText) {
    for (const Results& results : {sample_results(), waived_run(), Results{}})
        EXPECT_EQ(to_json(results_from_message_pack(to_message_pack(results))), to_json(results));
    Results results = sample_results();
    results.views[0].scene = "\xFF\xFE";
    EXPECT_EQ(results_from_message_pack(to_message_pack(results)).views[0].scene, "\xFF\xFE");
}

}  // namespace zproof
