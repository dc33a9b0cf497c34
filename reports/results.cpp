#include "reports/results.h"

#include <algorithm>
#include <cctype>

#include "frame/number_text.h"

namespace zproof {

namespace {

struct OutcomeRow {
    Outcome outcome;
    std::string_view name, words, glyph;
};

/// In reading order.
constexpr std::array<OutcomeRow, all_outcomes.size()> outcome_rows{{
    {Outcome::defective, "defective", "defective", "✗"},
    {Outcome::internal_error, "internal_error", "internal error", "!"},
    {Outcome::undecided, "undecided", "undecided", "?"},
    {Outcome::unreadable, "unreadable", "unreadable", "!"},
    {Outcome::not_judged, "not_judged", "not judged", "?"},
    {Outcome::proven, "proven", "proven", "✓"},
}};

const OutcomeRow& row_of(Outcome outcome) {
    return *std::ranges::find(outcome_rows, outcome, &OutcomeRow::outcome);
}

}  // namespace

std::string_view name_of(Ending ending) {
    switch (ending) {
        case Ending::complete:
            return "complete";
        case Ending::interrupted:
            return "interrupted";
        case Ending::stopped:
            return "stopped";
        case Ending::partial:
            return "partial";
    }
    return "";
}

std::string_view name_of(Outcome outcome) { return row_of(outcome).name; }
std::string_view in_words(Outcome outcome) { return row_of(outcome).words; }
std::string_view glyph_of(Outcome outcome) { return row_of(outcome).glyph; }

std::string title_of(const RendererFacts& renderer) {
    const std::string &name = renderer.name, &version = renderer.version;
    const auto alike = [](char a, char b) {
        return std::tolower(std::uint8_t(a)) == std::tolower(std::uint8_t(b));
    };
    if (version.empty()) return name;
    const bool repeats =
        version.size() >= name.size() && std::equal(name.begin(), name.end(), version.begin(), alike);
    return repeats ? version : name + " " + version;
}

std::string ids_in_words(const RendererFacts& renderer) {
    return renderer.ids == "none" ? "depth only" : "ids: " + renderer.ids;
}

bool was_judged(const ViewResult& view) {
    return view.outcome == Outcome::proven || view.outcome == Outcome::defective ||
           view.outcome == Outcome::undecided;
}

bool failed(const ViewResult& view) {
    return view.outcome != Outcome::proven && view.outcome != Outcome::not_judged;
}

bool stands_for_a_scene(const ViewResult& view) { return view.view.empty() && !was_judged(view); }

std::uint64_t defect_count(const ClassCounts& counts) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (is_defect(PixelClass(i))) sum += counts[i];
    return sum;
}

std::uint64_t defect_count(const ViewResult& view) { return defect_count(view.counts); }

std::uint64_t waived_count(const ViewResult& view) { return defect_count(view.waived); }

std::uint64_t unwaived_defects(const ViewResult& view) { return defect_count(view) - waived_count(view); }

std::string error_over_bound_words(const ViewResult& view) {
    const bool no_depth_is_wrong = view.counts[std::size_t(PixelClass::wrong_depth)] == 0;
    return defect_count(view) > 0 && no_depth_is_wrong ? "-"
                                                       : rounded(view.candidate_depth.max_error_over_bound);
}

double seconds(const StageTimes& t) {
    return t.load + t.render + t.reference_build + t.reference + t.judge + t.oracles + t.write;
}

std::vector<const ViewResult*> failed_first(const Results& results) {
    std::vector<const ViewResult*> views;
    for (const ViewResult& view : results.views) views.push_back(&view);
    std::ranges::stable_sort(views, {}, [](const ViewResult* v) { return &row_of(v->outcome); });
    return views;
}

}  // namespace zproof
