// Pages of runs of many views.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "reports/html.h"
#include "reports/html_parts.h"
#include "tests/reports/packed_page.h"
#include "tests/reports/sample.h"

namespace zproof {
namespace {

using nlohmann::json;

/// One view of a hundred is defective; no two have the same numbers. None has evidence.
Results many_views(std::size_t count) {
    const Results sample = sample_results();
    Results results = sample;
    std::mt19937 random(7);
    results.views.clear();
    for (std::size_t i = 0; i < count; ++i) {
        ViewResult view = sample.views[i % 100 == 37 ? 1 : 0];
        view.scene = "model-" + std::to_string(i / 8);
        view.view = "cam" + std::to_string(i % 8);
        view.source = "models/" + view.scene + ".glb";
        view.folder = "";
        view.triangles = random() % 1'000'000;
        view.counts[std::size_t(PixelClass::edge)] = random() % 10'000;
        view.candidate_depth.max_error_over_bound = double(random() % 1000) / 1000;
        for (std::uint64_t& bin : view.candidate_depth.histogram) bin = random() % 100'000;
        view.times.judge = double(random() % 1000) / 100;
        results.views.push_back(view);
    }
    return results;
}

json facts_of(const std::string& page) {
    json all = json::array();
    for (int pack = 0;; ++pack) {
        const std::string text = packed_text(page, "facts-" + std::to_string(pack));
        if (text.empty()) return all;
        for (const json& view : json::parse(text)) all.push_back(view);
    }
}

std::size_t place_of(const std::string& fact) {
    const std::vector<std::string> names = fact_names();
    return std::size_t(std::ranges::find(names, fact) - names.begin());
}

TEST(HtmlLength, OfTwentyThousandViewsAllAreListedWithinFiveMegabytes) {
    const std::string page = to_html(many_views(20'000), "/nowhere", 5'000'000);
    EXPECT_LE(page.size(), 5'000'000u);
    const json facts = facts_of(page);
    ASSERT_EQ(facts.size(), 20'000u);
    EXPECT_EQ(facts[199].at(place_of("outcome")), "defective");
    EXPECT_EQ(facts[200].at(place_of("outcome")), "proven") << "failed views first";
    EXPECT_EQ(facts[19'999].at(place_of("source")), "models/model-2499.glb");
    EXPECT_EQ(occurrences(page, "These are the first 200 of 20,000 views, failed ones first."), 1u);
    EXPECT_EQ(occurrences(page, "The table has the first "), 0u);
}

TEST(HtmlLength, TheFirstViewsStandInThePageAndTheNextOnesArePacked) {
    const std::string page = to_html(many_views(223), "/nowhere");
    EXPECT_EQ(occurrences(page, "<section id=\"view-"), 200u);
    EXPECT_EQ(occurrences(page, "<a href=\"#view-"), 200u);
    const std::string first = packed_text(page, "sections-0"), last = packed_text(page, "sections-1");
    EXPECT_TRUE(first.starts_with("<section id=\"view-201\">"));
    EXPECT_EQ(occurrences(first, "<section id=\"view-"), sections_in_pack);
    EXPECT_EQ(occurrences(last, "<section id=\"view-223\">"), 1u);
    EXPECT_EQ(packed_text(page, "sections-2"), "");
    EXPECT_EQ(occurrences(page, "left out to keep this page small"), 0u);
}

TEST(HtmlLength, AShortRunIsThereWithoutScripts) {
    const std::string page = to_html(many_views(200), "/nowhere");
    EXPECT_EQ(occurrences(page, "<section id=\"view-"), 200u);
    EXPECT_EQ(occurrences(page, "id=\"sections-0\""), 0u);
    EXPECT_EQ(occurrences(page, "These are the first"), 0u);
}

TEST(HtmlLength, WhatHasNoRoomIsLeftOutFromTheEndAndThePageSaysSo) {
    const std::string page = to_html(many_views(20'000), "/nowhere", 2'500'000);
    EXPECT_LE(page.size(), 2'500'000u);
    const std::size_t listed = facts_of(page).size();
    EXPECT_GT(listed, 1'000u);
    EXPECT_LT(listed, 20'000u);
    EXPECT_EQ(
        occurrences(page, "The table has the first " + std::to_string(listed / 1000) + ",000 views alone."),
        1u);
    EXPECT_EQ(occurrences(page, "those of the others were left out to keep this page small"), 1u);
}

TEST(HtmlLength, ARowIsTheSameForReadersWithAndWithoutScripts) {
    const Results results = many_views(1);
    const std::vector<std::string> texts = summary_texts(results.views[0]);
    const std::string page = to_html(results, "/nowhere"), row = facts_of(page)[0].at(place_of("row"));
    std::string joined, cells;
    for (const std::string& text : texts) {
        joined += (joined.empty() ? "" : "\t") + text;
        EXPECT_GE(occurrences(page, ">" + text + "</td>"), 1u) << text;
    }
    EXPECT_EQ(row, joined);
    EXPECT_EQ(texts.size(), summary_columns().size());
}

}  // namespace
}  // namespace zproof
