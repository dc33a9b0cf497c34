#include "reports/measurement_report.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "reports/wording.h"

namespace zproof {
namespace {

using measure::Bracket;
using measure::Conformity;

/// "8.0 +- 1.2e-06 bits"
std::string number_of(const Bracket& bracket, const std::string& unit) {
    std::string text = unit == "bits" ? fixed(bracket.middle(), 1) : with_digits(bracket.middle(), 6);
    if (const double half_width = (bracket.high - bracket.low) / 2; half_width > 0)
        text += " +- " + with_digits(half_width, 2);
    return unit.empty() ? text : text + " " + unit;
}

std::string_view key_of(Conformity conformity) {
    switch (conformity) {
        case Conformity::as_declared:
            return "as_declared";
        case Conformity::worse:
            return "worse";
        case Conformity::undeclared:
            return "undeclared";
    }
    return "undeclared";
}

using Row = std::array<std::string, 4>;

std::string table_of(const std::vector<Row>& rows) {
    std::array<std::size_t, 4> width{};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
    }
    std::string text;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i)
            text += row[i] + std::string(width[i] - row[i].size() + 2, ' ');
        text += row.back() + "\n";
    }
    return text;
}

std::string verdict(const std::string& renderer, std::span<const measure::Finding> findings) {
    const auto worse = std::ranges::count(findings, Conformity::worse, &measure::Finding::conformity);
    if (worse == 0) return renderer + ": as declared\n";
    return renderer + ": worse than declared in " + std::to_string(worse) + " of " +
           std::to_string(findings.size()) + "\n";
}

}  // namespace

std::string measured_in_words(const measure::Finding& finding) {
    if (!finding.value) return finding.words;
    const std::string number = number_of(*finding.value, finding.unit);
    return finding.words.empty() ? number : number + " (" + finding.words + ")";
}

std::string_view in_words(Conformity conformity) {
    switch (conformity) {
        case Conformity::as_declared:
            return "as declared";
        case Conformity::worse:
            return "WORSE";
        case Conformity::undeclared:
            return "-";
    }
    return "-";
}

std::string measurement_table(const std::string& renderer, std::span<const measure::Finding> findings) {
    std::vector<Row> rows{{"finding", "measured", "declared", "conformity"}};
    for (const measure::Finding& f : findings)
        rows.push_back(
            {f.title, one_line(measured_in_words(f)), f.declared, std::string{in_words(f.conformity)}});
    return table_of(rows) + "\n" + verdict(renderer, findings);
}

std::string measurement_json(const std::string& renderer, std::span<const measure::Finding> findings) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const measure::Finding& f : findings) {
        nlohmann::ordered_json one{{"name", f.name}, {"title", f.title}};
        if (f.value) one["value"] = {{"low", f.value->low}, {"high", f.value->high}};
        if (!f.unit.empty()) one["unit"] = f.unit;
        if (!f.words.empty()) one["words"] = f.words;
        if (!f.declared.empty()) one["declared"] = f.declared;
        one["conformity"] = key_of(f.conformity);
        all.push_back(std::move(one));
    }
    const nlohmann::ordered_json whole{
        {"renderer", renderer}, {"worse", measure::is_worse(findings)}, {"findings", all}};
    return whole.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace zproof
