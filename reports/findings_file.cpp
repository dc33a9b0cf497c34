#include "reports/findings_file.h"

#include <charconv>
#include <optional>
#include <sstream>

#include "reports/report_error.h"

namespace zproof {

namespace {

template <class Number>
std::optional<Number> number(const std::string& text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc{} && read.ptr == end ? std::optional{value} : std::nullopt;
}

std::optional<PrimitiveId> id_from(const std::string& text) {
    if (text == "none") return PrimitiveId::none;
    const auto id = number<std::uint32_t>(text);
    return id ? std::optional{PrimitiveId(*id)} : std::nullopt;
}

std::optional<PixelClass> class_from(const std::string& name) {
    for (int i = 0; i < pixel_class_count; ++i)
        if (name_of(PixelClass(i)) == name) return PixelClass(i);
    return std::nullopt;
}

std::optional<Finding> finding_from(const std::string& line) {
    std::istringstream in{line};
    std::vector<std::string> cells;
    for (std::string cell; cells.size() < 5 && std::getline(in, cell, ',');) cells.push_back(cell);
    if (cells.size() < 5) return std::nullopt;
    const auto x = number<int>(cells[0]), y = number<int>(cells[1]);
    const auto verdict = class_from(cells[2]);
    const auto candidate = id_from(cells[3]), reference = id_from(cells[4]);
    if (!x || !y || !verdict || !candidate || !reference) return std::nullopt;
    Finding finding{
        .x = *x, .y = *y, .verdict = *verdict, .candidate = {}, .reference = {}, .candidate_depth = {}};
    finding.candidate.primitive = *candidate;
    finding.reference.primitive = *reference;
    return finding;
}

}  // namespace

std::vector<Finding> findings_from_csv(const std::string& text, const std::string& name) {
    std::vector<Finding> findings;
    std::istringstream in{text};
    std::string line;
    std::getline(in, line);  // the heading
    for (std::size_t number = 2; std::getline(in, line); ++number) {
        const auto finding = finding_from(line);
        if (!finding)
            throw ReportError(name + ":" + std::to_string(number) +
                              ": expected x,y,class,candidate_id,reference_id,... as zproof writes it; run "
                              "zproof again");
        findings.push_back(*finding);
    }
    return findings;
}

}  // namespace zproof
