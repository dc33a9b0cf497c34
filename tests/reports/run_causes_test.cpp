#include "reports/run_causes.h"

#include <gtest/gtest.h>

namespace zproof {

namespace {

ViewResult failed_by(const std::string& cause) {
    ViewResult view;
    view.outcome = Outcome::defective;
    view.diagnosis = Diagnosis{};
    if (!cause.empty())
        view.diagnosis->cause = Explanation{.name = cause, .description = "", .look_at = "Look."};
    return view;
}

Results run_of(const std::vector<std::string>& causes) {
    Results results;
    for (const std::string& cause : causes) results.views.push_back(failed_by(cause));
    return results;
}

TEST(RunCauses, AreCountedByViewsTheCommonestFirst) {
    const std::vector<RunCause> causes = run_causes(run_of({"a", "b", "", "b", "c"}));
    ASSERT_EQ(causes.size(), 3u);
    EXPECT_EQ(causes[0].name, "b");
    EXPECT_EQ(causes[0].views, 2u);
    EXPECT_EQ(causes[1].name, "a") << "of as many views, the first that was named";
    EXPECT_EQ(cause_in_words(run_of({"a", "b", "", "b", "c"})),
              "Likely cause of 2 of 5 failed views: b. Look.");
}

TEST(RunCauses, AreWeighedByWhatTheySpare) {
    Results results = run_of({"a", "b", "a"});
    results.views[1].diagnosis->cause->saved_bits = 100;
    results.views[1].diagnosis->cause->saved_share = 0.8;
    EXPECT_EQ(run_causes(results)[0].name, "b") << "one view of many defects";
    EXPECT_EQ(run_causes(results)[0].saved_bits, 100);
    EXPECT_DOUBLE_EQ(run_causes(results)[0].all_bits, 125);
}

TEST(RunCauses, AreNotSoughtWhereThatIsLeftOut) {
    Results results = run_of({"", ""});
    results.diagnosis = CauseSearch::left_out;
    EXPECT_EQ(cause_in_words(results), "No cause was sought (--no-diagnosis).");
    results.views.clear();
    EXPECT_EQ(cause_in_words(results), "");
}

TEST(RunCauses, AreNotThoseOfWaivedViews) {
    Results results = run_of({"a", "b"});
    results.views[0].outcome = Outcome::proven;
    EXPECT_EQ(failed_views(results), 1u);
    ASSERT_EQ(run_causes(results).size(), 1u);
    EXPECT_EQ(run_causes(results)[0].name, "b");
}

TEST(RunCauses, SayTheNumberThatAllTheirViewsFit) {
    Results results = run_of({"a", "a"});
    for (ViewResult& view : results.views) view.diagnosis->cause->fitted = "told times 1.1";
    EXPECT_EQ(cause_in_words(results), "Likely cause of all 2 failed views: a: told times 1.1. Look.");
    results.views[1].diagnosis->cause->fitted = "told times 1.2";
    EXPECT_EQ(cause_in_words(results), "Likely cause of all 2 failed views: a. Look.");
}

TEST(RunCauses, SayHowManyViewsTheyExplain) {
    EXPECT_EQ(cause_in_words(run_of({"a", "a"})), "Likely cause of all 2 failed views: a. Look.");
    EXPECT_EQ(cause_in_words(run_of({"a"})), "Likely cause: a. Look.");
    EXPECT_EQ(cause_in_words(run_of({"", ""})), "No cause is certain.");
    EXPECT_EQ(cause_in_words(run_of({})), "");
}

}  // namespace

}  // namespace zproof
