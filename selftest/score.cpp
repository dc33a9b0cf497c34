#include "selftest/score.h"

#include <iomanip>
#include <map>
#include <sstream>

#include "selftest/test_scene.h"

namespace zproof::selftest {
namespace {

/// What the line of a fault begins with.
const char* mark_of(const Fault& fault, const FaultResult& result) {
    if (is_control(fault)) return result.as_expected ? "passed" : "FAILED";
    return result.as_expected ? "caught" : "MISSED";
}

std::string line_of(const Fault& fault, const FaultResult& result) {
    std::ostringstream line;
    line << mark_of(fault, result) << "  " << std::left << std::setw(32) << fault.name << in_words(result)
         << " (" << fault.sentence << ")\n";
    return line.str();
}

void count(Score& score, const Fault& fault, const FaultResult& result) {
    (is_control(fault) ? score.controls : score.faults) += 1;
    (is_control(fault) ? score.passed : score.caught) += result.as_expected;
}

}  // namespace

Score try_all(const std::vector<Fault>& faults, const ProgressSink& progress_sink) {
    std::map<FixtureSize, TestScene> test_scenes;  // made when first needed
    Score score;
    for (const Fault& fault : faults) {
        if (progress_sink.wants_to_stop()) break;
        progress_sink.begins(fault.name);
        const TestScene& test_scene =
            test_scenes.try_emplace(fault.fixture_size, fault.fixture_size).first->second;
        const FaultResult result = try_fault(fault, test_scene.fixture());
        progress_sink.told(line_of(fault, result));
        count(score, fault, result);
    }
    return score;
}

}  // namespace zproof::selftest
