#include "reports/merge.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reports/report_error.h"
#include "reports/waiver_json.h"

namespace zproof {

namespace {

std::string renderers_of(const Results& r) {
    std::string text;
    for (const RendererFacts& facts : r.renderers)
        text += (text.empty() ? "" : "; ") + title_of(facts) + " " + facts.precision + " ids: " + facts.ids;
    return text;
}

std::string waivers_of(const Results& r) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Waiver& waiver : r.waivers) list.push_back(waiver_object(waiver));
    return list.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Something that all shards of one run have in common.
struct Common {
    const char* what;
    std::string (*of)(const Results&);
    const char* remedy;
};

const std::vector<Common>& common_things() {
    static const std::vector<Common> all{
        {"zproof's version", [](const Results& r) { return r.version; }, "run all shards with one zproof"},
        {"zproof's commit", [](const Results& r) { return r.commit; }, "run all shards with one zproof"},
        {"the compiler", [](const Results& r) { return r.compiler; }, "run all shards with one zproof"},
        {"Embree's version", [](const Results& r) { return r.embree; }, "run all shards with one Embree"},
        {"the renderers or what they declare", renderers_of, "judge one renderer, with the same oracles"},
        {"the selection of scenes or the resolution", [](const Results& r) { return r.selection.sha256; },
         "give all shards the same scenes, --width and --height"},
        {"the number of shards", [](const Results& r) { return std::to_string(r.shard.count); },
         "run all shards with the same count"},
        {"the waivers", waivers_of, "give all shards the same waiver file"},
        {"the day of the waivers", [](const Results& r) { return r.today; }, "give all shards one --now"},
        {"--strict", [](const Results& r) { return std::to_string(int(r.strictness)); },
         "run all shards with it or without it"},
    };
    return all;
}

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
    throw ReportError(name + ": " + why);
}

std::string word_of(const Shard& shard) {
    return "hash:" + std::to_string(shard.number) + "/" + std::to_string(shard.count);
}

void require_one_run(const std::vector<Results>& shards, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < shards.size(); ++i) {
        if (shards[i].selection.sha256.empty())
            refuse(names[i], "was written by an older zproof, or is no run; run that shard again");
        if (shards[i].ending == Ending::interrupted)
            refuse(names[i], "was interrupted; run shard " + word_of(shards[i].shard) + " again");
        for (const Common& thing : common_things())
            if (const std::string here = thing.of(shards[i]), first = thing.of(shards[0]); here != first)
                refuse(names[i], std::string{thing.what} + " differs from that of " + names[0] + " (" +
                                     here.substr(0, 200) + ", not " + first.substr(0, 200) + "); " +
                                     thing.remedy);
    }
}

void require_each_once(const std::vector<Results>& shards, const std::vector<std::string>& names) {
    const int count = shards[0].shard.count;
    std::vector<std::string> holder(std::size_t(count) + 1);
    for (std::size_t i = 0; i < shards.size(); ++i) {
        const int number = shards[i].shard.number;
        if (number < 1 || number > count) refuse(names[i], "there is no shard " + word_of(shards[i].shard));
        std::string& before = holder[std::size_t(number)];
        if (!before.empty())
            refuse(names[i], "is shard " + word_of(shards[i].shard) + ", and so is " + before +
                                 "; name every shard once");
        before = names[i];
    }
    for (int number = 1; number <= count; ++number)
        if (holder[std::size_t(number)].empty())
            refuse(names[0], "shard " + word_of({number, count}) + " is missing; name all " +
                                 std::to_string(count) + " of them");
}

/// Are all scenes of the selection there?
void require_all_scenes(const Results& whole, const std::string& name) {
    std::vector<bool> seen(whole.selection.scenes);
    for (const ViewResult& view : whole.views)
        if (view.place < seen.size()) seen[view.place] = true;
    if (const auto missing = std::ranges::count(seen, false); missing > 0)
        refuse(name, "of the " + std::to_string(seen.size()) + " scenes that were selected, " +
                         std::to_string(missing) + " are in no shard; run the shards again");
}

bool is_option_with_value(const std::string& word) {
    return word == "--shard" || word == "-o" || word == "--out";
}

bool is_option_and_value(const std::string& word) {
    return word.starts_with("--shard=") || word.starts_with("--out=") ||
           (word.starts_with("-o") && word.size() > 2);
}

}  // namespace

Results merged(const std::vector<Results>& shards, const std::vector<std::string>& names) {
    if (shards.empty()) throw ReportError("merge: no shard was named");
    require_one_run(shards, names);
    require_each_once(shards, names);
    Results whole = shards[0];
    whole.shard = {};
    whole.argv = without_shard_words(whole.argv);
    whole.views.clear();
    for (const Results& shard : shards) std::ranges::copy(shard.views, std::back_inserter(whole.views));
    std::ranges::stable_sort(whole.views, {}, &ViewResult::place);
    require_all_scenes(whole, names[0]);
    return whole;
}

std::vector<std::string> without_shard_words(const std::vector<std::string>& argv) {
    std::vector<std::string> rest;
    for (std::size_t i = 0; i < argv.size(); ++i) {
        if (is_option_with_value(argv[i]))
            ++i;
        else if (!is_option_and_value(argv[i]))
            rest.push_back(argv[i]);
    }
    return rest;
}

}  // namespace zproof
