#include "cli/times_table.h"

#include <array>
#include <utility>

#include "reports/wording.h"

namespace zproof {
namespace {

using Stage = std::pair<const char*, double StageTimes::*>;
constexpr std::array stages{Stage{"load", &StageTimes::load},
                            Stage{"render", &StageTimes::render},
                            Stage{"reference build", &StageTimes::reference_build},
                            Stage{"reference", &StageTimes::reference},
                            Stage{"judge", &StageTimes::judge},
                            Stage{"oracles", &StageTimes::oracles},
                            Stage{"write", &StageTimes::write}};

std::string padded_left(const std::string& text, std::size_t width) {
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string row(std::string name, double part, double whole) {
    name.resize(16, ' ');
    const double percent = whole > 0 ? 100 * part / whole : 0;
    return name + padded_left(fixed(part, 3), 10) + " s" + padded_left(fixed(percent, 1), 7) + " %\n";
}

}  // namespace

std::string times_table(const Results& results) {
    double whole = 0;
    for (const ViewResult& view : results.views) whole += seconds(view.times);
    std::string table;
    for (const auto& [name, member] : stages) {
        double part = 0;
        for (const ViewResult& view : results.views) part += view.times.*member;
        table += row(name, part, whole);
    }
    return table + row("together", whole, whole);
}

}  // namespace zproof
