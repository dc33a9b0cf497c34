/// The selftest itself can fail: a fault that is no fault, the wrong class, the wrong count, a false alarm.
#include <gtest/gtest.h>

#include <string>

#include "selftest/score.h"

namespace zproof::selftest {
namespace {

using Answer = Expected::Answer;

Frame good(const Fixture& fixture) { return fixture.good; }

Frame with_a_hole(const Fixture& fixture) {
    Frame frame = fixture.good;
    for (std::size_t i = frame.size().pixel_count() / 2;; ++i) {
        PrimitiveId& id = frame.primitive.pixels()[i];
        if (id == PrimitiveId::none) continue;
        id = PrimitiveId::none;
        return frame;  // with its depth left: invalid
    }
}

/// The line that the fault gets, and the score.
std::pair<std::string, Score> told(Expected expected, std::function<Frame(const Fixture&)> inject) {
    std::string lines;
    const Score score = try_all({{"x", "y", std::move(expected), std::move(inject)}},
                                {.told = [&](const std::string& line) { lines += line; }});
    return {lines, score};
}

TEST(Score, ACaughtFaultCounts) {
    const auto [line, score] = told({.classes = {PixelClass::invalid}, .count = 1}, with_a_hole);
    EXPECT_EQ(line.find("caught  x "), 0u) << line;
    EXPECT_NE(line.find("1 invalid (y)\n"), std::string::npos) << line;
    EXPECT_TRUE(score.gate_works());
}

TEST(Score, AFaultThatTheGateLetsPassIsMissed) {
    const auto [line, score] = told({.classes = {}, .count = {}}, good);
    EXPECT_EQ(line.find("MISSED  x "), 0u) << line;
    EXPECT_NE(line.find("no defect"), std::string::npos) << line;
    EXPECT_FALSE(score.gate_works());
}

TEST(Score, TheWrongClassIsAMiss) {
    EXPECT_FALSE(told({.classes = {PixelClass::hole}, .count = {}}, with_a_hole).second.gate_works());
    EXPECT_FALSE(told({.classes = {PixelClass::invalid, PixelClass::hole}, .count = {}}, with_a_hole)
                     .second.gate_works());
}

TEST(Score, AnotherCountIsAMiss) {
    EXPECT_FALSE(told({.classes = {PixelClass::invalid}, .count = 2}, with_a_hole).second.gate_works());
    EXPECT_FALSE(told({.classes = {}, .count = 0}, with_a_hole).second.gate_works());
}

TEST(Score, AFalseAlarmIsAFailure) {
    const auto [line, score] = told({.answer = Answer::pass, .classes = {}, .count = {}}, with_a_hole);
    EXPECT_EQ(line.find("FAILED  x "), 0u) << line;
    EXPECT_FALSE(score.gate_works());
}

TEST(Score, AVerdictWhereNoneIsPossibleIsAMiss) {
    EXPECT_FALSE(told({.answer = Answer::refuse, .classes = {}, .count = {}}, good).second.gate_works());
    EXPECT_FALSE(
        told({.answer = Answer::refuse, .classes = {}, .count = {}}, with_a_hole).second.gate_works());
    const auto smaller = [](const Fixture&) { return Frame({1, 1}); };
    EXPECT_TRUE(told({.answer = Answer::refuse, .classes = {}, .count = {}}, smaller).second.gate_works());
    EXPECT_FALSE(told({.classes = {}, .count = {}}, smaller).second.gate_works());
}

TEST(Score, ControlsAloneProveNothing) {
    const auto [line, score] = told({.answer = Answer::pass, .classes = {}, .count = {}}, good);
    EXPECT_EQ(score.passed, 1);
    EXPECT_FALSE(score.gate_works());
}

}  // namespace
}  // namespace zproof::selftest
