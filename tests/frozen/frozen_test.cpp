/// The judge says today what was frozen: the same class at every pixel, and the same numbers where it fails.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "tests/frozen/record.h"
#include "tests/frozen/subjects.h"

namespace zproof::frozen {
namespace {

/// By name.
std::map<std::string, Record> recorded(const std::string& group) {
    std::map<std::string, Record> records;
    for (const Record& record : read_records(ZPROOF_FROZEN))
        if (record.group == group) records[record.name] = record;
    return records;
}

/// What a red line is to be looked at with.
std::string how_to_look(const Record& record) {
    return "see: freeze --text " + record.group + " " + record.name;
}

std::string what_changed(const Record& record, const Record& today) {
    if (record.counts.empty()) return "its counts are not recorded";
    const std::string changed = difference(record.counts, today.counts);
    return changed.empty() ? "as many of each, at other pixels" : changed;
}

void expect_same_verdict(const Subject& subject, const Record& record) {
    const Record today = record_of(subject, judged_text(subject));
    EXPECT_EQ(today.classes, record.classes)
        << "another class somewhere: " << what_changed(record, today) << "; " << how_to_look(record);
    EXPECT_EQ(today.story, record.story) << "other numbers somewhere; " << how_to_look(record);
    if (record.counts.empty()) return;
    EXPECT_EQ(difference(record.counts, today.counts), "") << "other counts than in frozen.txt";
}

class SameOnEveryMachine : public testing::TestWithParam<std::string> {};

TEST_P(SameOnEveryMachine, IsJudgedAsItWas) {
    const std::map<std::string, Record> records = recorded(GetParam());
    ASSERT_FALSE(records.empty());
    std::size_t met = 0;
    each_subject({GetParam()}, [&](const Subject& subject) {
        SCOPED_TRACE(subject.name);
        ASSERT_TRUE(records.contains(subject.name)) << "not recorded";
        const Record& record = records.at(subject.name);
        EXPECT_FALSE(record.counts.empty()) << "without counts by class";
        ++met;
        ASSERT_EQ(input_sha256(subject), record.input) << "not the frames that were recorded";
        expect_same_verdict(subject, record);
    });
    EXPECT_EQ(met, records.size());
}

INSTANTIATE_TEST_SUITE_P(Frozen, SameOnEveryMachine, testing::Values("planted", "moved", "random"),
                         [](const auto& group) { return group.param; });

/// Embree, OpenGL and POV-Ray give other frames on other processors, of which nothing is known.
void expect_known_frames_judged_as_they_were(const std::string& group) {
    const std::map<std::string, Record> records = recorded(group);
    ASSERT_FALSE(records.empty());
    std::size_t known = 0;
    each_subject({group}, [&](const Subject& subject) {
        SCOPED_TRACE(subject.name);
        const auto record = records.find(subject.name);
        if (record == records.end() || input_sha256(subject) != record->second.input) return;
        ++known;
        expect_same_verdict(subject, record->second);
    });
    std::cout << group << ": " << known << " of " << records.size() << " recorded pairs of frames met\n";
}

class PerMachine : public testing::TestWithParam<std::string> {};

TEST_P(PerMachine, IsJudgedAsItWasWhereTheFramesAreKnown) {
    expect_known_frames_judged_as_they_were(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Frozen, PerMachine, testing::Values("suite", "selftest"),
                         [](const auto& group) { return group.param; });

INSTANTIATE_TEST_SUITE_P(FrozenSlow, PerMachine, testing::Values("opengl", "povray", "models"),
                         [](const auto& group) { return group.param; });

}  // namespace
}  // namespace zproof::frozen
