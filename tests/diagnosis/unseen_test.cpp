// No cause is named that is not the true one, of defects that no hypothesis was written for.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "compare/diagnosis/diagnosis.h"
#include "compare/judge.h"
#include "frame/precision_text.h"
#include "oracle/embree.h"
#include "scenes/suite.h"
#include "tests/diagnosis/unseen_caster.h"

namespace zproof::test {
namespace {

/// The first of three scenes at which the defect shows.
std::optional<Diagnosis> diagnosed(const CasterDefect& defect) {
    const Precision promise = precision_from_word("ray,arithmetic=float64,test=moeller_trumbore");
    for (const char* name : {"near_plane", "interpenetrating", "guard_band"}) {
        const Loaded loaded = generate_suite_scene(name, 240, 135);
        const View& view = loaded.views.front();
        const Frame frame = cast(loaded.scene, view, defect),
                    reference = oracle::Embree(loaded.scene).trace(view);
        const RenderedFrame ours{frame, promise}, theirs{reference, oracle::embree_precision()};
        const Verdict verdict = judge(loaded.scene, view, ours, theirs);
        if (auto diagnosis = diagnose(loaded.scene, view, ours, theirs, verdict)) return diagnosis;
    }
    return std::nullopt;
}

/// The cause, and what is told with it as good: where the frame does not tell which it is.
std::vector<std::string> told_causes(const Diagnosis& diagnosis) {
    std::vector<std::string> told{diagnosis.cause->name};
    if (diagnosis.runners_up.empty()) return told;
    const Explanation& next = diagnosis.runners_up.front();
    const bool is_as_good =
        next.saved_share > diagnosis.cause->saved_share - alike_shares &&
        next.explained * diagnosis.cause->asked >= diagnosis.cause->explained * next.asked;
    if (is_as_good) told.push_back(next.name);
    return told;
}

TEST(UnseenDefects, GetTheirTrueNameOrNone) {
    int named = 0;
    for (const CasterDefect& defect : caster_defects()) {
        const auto diagnosis = diagnosed(defect);
        EXPECT_EQ(diagnosis.has_value(), defect.name != "none") << defect.name;
        const bool is_named = diagnosis && diagnosis->cause;
        std::cout << defect.name << ": " << (is_named ? diagnosis->cause->name : "-") << std::endl;
        if (!is_named) continue;
        ++named;
        EXPECT_TRUE(std::ranges::any_of(told_causes(*diagnosis),
                                        [&](const std::string& said) {
                                            return std::ranges::any_of(
                                                defect.true_names,
                                                [&](const std::string& t) { return said.starts_with(t); });
                                        }))
            << defect.name << " is called '" << diagnosis->cause->name << "'";
    }
    EXPECT_GE(named, 18);
}

}  // namespace
}  // namespace zproof::test
