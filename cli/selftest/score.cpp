#include "cli/selftest/score.h"

#include <iomanip>
#include <map>
#include <sstream>

#include "cli/selftest/theatre.h"

namespace zproof::selftest {
namespace {

/// What the line of a fault begins with.
const char* mark_of(const Fault& fault, const Trial& trial) {
    if (is_control(fault)) return trial.as_expected ? "passed" : "FAILED";
    return trial.as_expected ? "caught" : "MISSED";
}

std::string line_of(const Fault& fault, const Trial& trial) {
    std::ostringstream line;
    line << mark_of(fault, trial) << "  " << std::left << std::setw(32) << fault.name << in_words(trial)
         << " (" << fault.sentence << ")\n";
    return line.str();
}

void count(Score& score, const Fault& fault, const Trial& trial) {
    (is_control(fault) ? score.controls : score.faults) += 1;
    (is_control(fault) ? score.passed : score.caught) += trial.as_expected;
}

}  // namespace

Score try_all(const std::vector<Fault>& faults, const Audience& audience) {
    std::map<StageSize, Theatre> theatres;  // made when first needed
    Score score;
    for (const Fault& fault : faults) {
        if (audience.wants_to_stop()) break;
        audience.begins(fault.name);
        const Theatre& theatre = theatres.try_emplace(fault.stage_size, fault.stage_size).first->second;
        const Trial trial = try_fault(fault, theatre.stage());
        audience.told(line_of(fault, trial));
        count(score, fault, trial);
    }
    return score;
}

}  // namespace zproof::selftest
