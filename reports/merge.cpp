#include "reports/merge.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "reports/expectations.h"
#include "reports/json.h"
#include "reports/report_error.h"

namespace zproof {

namespace {

std::string renderers_of(const Results& r) {
    std::string text;
    for (const RendererFacts& facts : r.renderers)
        text += (text.empty() ? "" : "; ") + title_of(facts) + " " + facts.precision + " ids: " + facts.ids;
    return text;
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
        {"the plan", [](const Results& r) { return r.shard.plan; }, "run all shards of one plan"},
        {"the waivers", [](const Results& r) { return waivers_as_json(r.waivers); },
         "give all shards the same waiver file"},
        {"the day of the waivers", [](const Results& r) { return r.today; }, "give all shards one --now"},
        {"--strict", [](const Results& r) { return std::to_string(int(r.strictness)); },
         "run all shards with it or without it"},
        {"--no-diagnosis", [](const Results& r) { return std::to_string(int(r.diagnosis)); },
         "run all shards with it or without it"},
    };
    return all;
}

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
    throw ReportError(name + ": " + why);
}

std::string in_words(const Shard& shard) {
    const std::string number = std::to_string(shard.number), count = std::to_string(shard.count);
    return shard.plan.empty() ? "hash:" + number + "/" + count : number + " of " + count;
}

/// A scene's place, and then the view's: what stands for a whole scene goes first.
bool is_before(const ViewResult& a, const ViewResult& b) {
    return std::pair{a.place, a.view_place} < std::pair{b.place, b.view_place};
}

bool have_one_place(const ViewResult& a, const ViewResult& b) {
    return std::tuple{a.place, a.view_place, a.scene_views} ==
           std::tuple{b.place, b.view_place, b.scene_views};
}

/// Each shard of a scene that could not be read says so.
bool stand_for_one_scene(const ViewResult& a, const ViewResult& b) {
    return have_one_place(a, b) && a.scene_views == 0;
}

void require_each_view_once(const std::vector<ViewResult>& views, const std::string& name) {
    const auto twice = std::ranges::adjacent_find(views, have_one_place);
    if (twice != views.end())
        refuse(name,
               "view " + twice->view + " of " + twice->scene + " is in two shards; run the shards again");
}

/// The views are one scene's. Shards that read it before and after it was changed are of no one run.
void require_one_scene(std::span<const ViewResult> views, const std::string& name) {
    std::set<std::string> contents;
    for (const ViewResult& view : views)
        if (!view.scene_sha256.empty()) contents.insert(view.scene_sha256);
    if (contents.size() > 1)
        refuse(name, "the shards judged different contents of scene " + views.front().scene +
                         "; run the shards again");
}

/// The views of each scene together.
template <class Work>
void for_each_scene(std::vector<ViewResult>& views, const Work& work) {
    for (auto begin = views.begin(); begin != views.end();) {
        const auto end =
            std::find_if(begin, views.end(), [&](const ViewResult& v) { return v.place != begin->place; });
        work(std::span{begin, end});
        begin = end;
    }
}

/// The views are one scene's. What stands for a whole scene that could not be read has no views, and none is
/// missing.
std::size_t missing_views(std::span<const ViewResult> views) {
    const std::size_t all = std::ranges::max(views, {}, &ViewResult::scene_views).scene_views;
    const auto there = std::size_t(std::ranges::count(views, all, &ViewResult::scene_views));
    return all == 0 ? 0 : all - there;
}

/// Are all views of all scenes there?
void require_all_views(Results& whole, const std::string& name) {
    std::size_t scenes = 0, views = 0;
    for_each_scene(whole.views, [&](std::span<const ViewResult> some) {
        ++scenes;
        views += missing_views(some);
    });
    if (scenes < whole.selection.scenes)
        refuse(name, "of the " + std::to_string(whole.selection.scenes) + " scenes that were selected, " +
                         std::to_string(whole.selection.scenes - scenes) +
                         " are in no shard; run the shards again");
    if (views > 0)
        refuse(name, std::to_string(views) +
                         " views of scenes that were judged are in no shard; run the shards again");
}

bool is_option_with_value(const std::string& word) {
    return word == "--shard" || word == "--empty-shard" || word == "-o" || word == "--out";
}

bool is_one_word(const std::string& word) {
    return word == "--exit-zero" || word.starts_with("--shard=") || word.starts_with("--empty-shard=") ||
           word.starts_with("--out=") || (word.starts_with("-o") && word.size() > 2);
}

}  // namespace

void Merging::require_same_run(const Results& shard, const std::string& name) const {
    if (shard.selection.sha256.empty())
        refuse(name, "was written by an older zproof, or is no run; run that shard again");
    if (shard.ending == Ending::interrupted || shard.ending == Ending::stopped)
        refuse(name, "was " + std::string(name_of(shard.ending)) + "; run shard " + in_words(shard.shard) +
                         " again");
    if (first_.empty()) return;
    for (const Common& thing : common_things())
        if (const std::string here = thing.of(shard), first = thing.of(all_); here != first)
            refuse(name, std::string{thing.what} + " differs from that of " + first_ + " (" +
                             here.substr(0, 200) + ", not " + first.substr(0, 200) + "); " + thing.remedy);
}

void Merging::hold(const Shard& shard, const std::string& name) {
    if (shard.number < 1 || shard.number > shard.count) refuse(name, "there is no shard " + in_words(shard));
    holders_.resize(std::size_t(shard.count) + 1);
    std::string& before = holders_[std::size_t(shard.number)];
    if (!before.empty())
        refuse(name, "is shard " + in_words(shard) + ", and so is " + before + "; name every shard once");
    before = name;
}

void Merging::add(Results shard, const std::string& name) {
    require_same_run(shard, name);
    hold(shard.shard, name);
    std::vector<ViewResult> views = std::move(shard.views);
    if (first_.empty()) {
        first_ = name;
        all_ = std::move(shard);
        all_.views.clear();
    }
    std::ranges::move(views, std::back_inserter(all_.views));
}

void Merging::require_all_shards() const {
    if (holders_.empty()) throw ReportError("merge: no shard was named");
    const int count = int(holders_.size()) - 1;
    for (int number = 1; number <= count; ++number)
        if (!has(number))
            refuse(first_, "shard " + in_words({number, count, all_.shard.plan}) + " is missing; name all " +
                               std::to_string(count) + " of them");
}

Results Merging::put_together() && {
    Results whole = std::move(all_);
    whole.shard = {};
    whole.argv = without_shard_words(whole.argv);
    std::ranges::stable_sort(whole.views, is_before);
    whole.views.erase(std::unique(whole.views.begin(), whole.views.end(), stand_for_one_scene),
                      whole.views.end());
    require_each_view_once(whole.views, first_);
    for_each_scene(whole.views, [&](std::span<ViewResult> views) {
        require_one_scene(views, first_);
        hold_to_expectations(views);
    });
    return whole;
}

Results Merging::whole() && {
    require_all_shards();
    const std::string first = first_;
    Results whole = std::move(*this).put_together();
    require_all_views(whole, first);
    return whole;
}

Results Merging::partial(std::vector<ViewResult> missing) && {
    std::ranges::move(missing, std::back_inserter(all_.views));
    Results whole = std::move(*this).put_together();
    whole.ending = Ending::partial;
    return whole;
}

std::vector<std::string> without_shard_words(const std::vector<std::string>& argv) {
    std::vector<std::string> rest;
    for (std::size_t i = 0; i < argv.size(); ++i) {
        if (is_option_with_value(argv[i]))
            ++i;
        else if (!is_one_word(argv[i]))
            rest.push_back(argv[i]);
    }
    return rest;
}

}  // namespace zproof
