#include "filters/commands/checked_picture.h"

#include <array>
#include <iomanip>
#include <sstream>

#include "filters/commands/joint_check.h"
#include "filters/selftest/likely_cause.h"

namespace zproof {
namespace {

using selftest::ConformanceResult;
using JsonTree = nlohmann::json;

/// "0 of 262144 pixels outside, slack 0.93"
std::string found_in_words(const ConformanceResult& result) {
    if (result.is_caught()) return selftest::in_words(result);
    std::ostringstream text;
    text << "no pixel of " << result.found.judged << " outside, slack " << std::setprecision(3)
         << result.found.worst_slack;
    if (result.found.anything > 0) text << "; " << result.found.anything << " undecided";
    if (result.chance) text << "; " << selftest::in_words(*result.chance);
    return text.str();
}

std::string where_in_words(const Conformance& found) {
    if (!found.where) return "";
    std::ostringstream text;
    text << "; worst at (" << found.worst.x << ", " << found.worst.y << "), all within columns "
         << found.where->first.x << " to " << found.where->last.x << ", rows " << found.where->first.y
         << " to " << found.where->last.y;
    return text.str();
}

/// Estimates mean nothing where any picture would pass.
std::vector<std::string> further_lines(const CheckedPicture& checked) {
    std::vector<std::string> lines;
    if (checked.joint)
        lines = checked.is_open() ? std::vector{promised_in_words(*checked.joint)} : in_words(*checked.joint);
    if (checked.power)
        for (const std::string& line : in_words(*checked.power, checked.result.found)) lines.push_back(line);
    return lines;
}

/// With its three standard errors on either side; without both where the estimate is not to be had.
JsonTree of_offset(const OffsetEstimate& offset, bool is_known) {
    JsonTree one{{"name", offset.name},
                 {"unit", offset.unit},
                 {"promised", offset.promised},
                 {"log2_chance", offset.log2_chance},
                 {"leaves_promise", offset.leaves_promise},
                 {"value", nullptr},
                 {"interval", nullptr}};
    if (!is_known || !offset.is_told) return one;
    const double reach = 3 * offset.standard_error;
    one["value"] = offset.value;
    one["interval"] = {offset.value - reach, offset.value + reach};
    return one;
}

JsonTree of_joint(const JointConformance& joint, bool is_open) {
    JsonTree offsets = JsonTree::array(), nearer = JsonTree::array();
    for (const OffsetEstimate& offset : joint.offsets)
        offsets.push_back(of_offset(offset, joint.are_offsets_known() && !is_open));
    for (const AlternativeFit& other : joint.alternatives)
        if (other.is_nearer) nearer.push_back(other.name);
    return {{"offsets", std::move(offsets)},
            {"nearer_alternatives", std::move(nearer)},
            {"leaves_promise", joint.leaves_promise()}};
}

JsonTree of_power(const CheckPower& power) {
    return {{"would_refuse", power.refused},
            {"would_not_refuse", power.admitted},
            {"unproven", power.unproven},
            {"settings_that_prove", power.settings},
            {"wide_share", power.wide_share}};
}

}  // namespace

std::string in_words(const CheckedPicture& checked) {
    std::string text = (checked.is_wrong()  ? "FAILED  "
                        : checked.is_open() ? "nothing "
                                            : "passed  ") +
                       checked.scene + " / " + checked.view + ": " + checked.method + ": " +
                       found_in_words(checked.result) + selftest::causes_in_words(checked.causes) +
                       where_in_words(checked.result.found) + "\n";
    for (const std::string& line : further_lines(checked)) text += "        " + line + "\n";
    return text;
}

JsonTree to_json(const CheckedPicture& checked) {
    const Conformance& found = checked.result.found;
    const glm::dvec3& width = found.mean_width_of;
    JsonTree one{{"scene", checked.scene},
                 {"view", checked.view},
                 {"method", checked.method},
                 {"outcome", checked.is_wrong()  ? "failed"
                             : checked.is_open() ? "nothing"
                                                 : "passed"},
                 {"pixels", found.judged},
                 {"outside", found.outside},
                 {"undecided", found.anything},
                 {"slack", found.worst_slack},
                 {"worst", found.outside > 0 ? JsonTree{found.worst.x, found.worst.y} : JsonTree(nullptr)},
                 {"permitted_width", {width.r, width.g, width.b}},
                 {"causes", checked.causes},
                 {"text", in_words(checked)}};
    if (const auto& chance = checked.result.chance; chance && chance->pixels > 0) {
        const StochasticTest& worst = chance->worst();
        one["chance"] = {{"test", worst.name}, {"z", worst.z}, {"limit", worst.limit}};
    }
    if (checked.joint) one["joint"] = of_joint(*checked.joint, checked.is_open());
    if (checked.power) one["power"] = of_power(*checked.power);
    return one;
}

}  // namespace zproof
