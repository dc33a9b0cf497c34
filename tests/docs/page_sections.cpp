// Prints what pages say as the code says it, {"docs/suite.md": {"suite": "| scene | ..."}}: pages.py writes
// it between the page's marks.
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "filters/methods/catalogue.h"
#include "program/exit_code.h"
#include "scenes/filters/filter_scenes.h"
#include "scenes/random_scenes.h"
#include "scenes/suite.h"

namespace {

using namespace zproof;
using Cells = std::vector<std::string>;

std::string code(std::string_view name) { return "`" + std::string(name) + "`"; }

std::string table_row(const Cells& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += " " + cell + " |";
    return line + "\n";
}

std::string table(const Cells& head, const std::vector<Cells>& rows) {
    std::string text = table_row(head) + "|";
    for (std::size_t i = 0; i < head.size(); ++i) text += "---|";
    text += "\n";
    for (const Cells& row : rows) text += table_row(row);
    return text;
}

std::string suite_table(const std::vector<SuiteEntry>& entries) {
    std::vector<Cells> rows;
    for (const SuiteEntry& entry : entries) {
        std::string classes;
        for (const std::string& name : entry.expects) classes += (classes.empty() ? "" : ", ") + code(name);
        rows.push_back({code(entry.name), entry.reason, classes});
    }
    return table({"scene", "why it is there", "must show"}, rows);
}

std::string table_of_kinds() {
    std::vector<Cells> rows;
    for (const RandomKind& kind : random_kinds()) rows.push_back({code(kind.name), std::string(kind.reason)});
    return table({"kind", "what"}, rows);
}

std::string table_of_filter_scenes() {
    std::vector<Cells> rows;
    for (const FilterSceneEntry& scene : filter_scenes()) rows.push_back({code(scene.name), scene.reason});
    return table({"scene", "why it is there"}, rows);
}

std::string table_of_exit_statuses() {
    std::vector<Cells> rows;
    for (const ExitStatus& status : exit_statuses())
        rows.push_back({std::to_string(int(status.code)), std::string(status.meaning)});
    return table({"status", "meaning"}, rows);
}

/// A line for each fact: pages.py breaks it.
std::string definition_cards() {
    std::string text;
    for (const texture::Method& method : texture::methods())
        text += "\n### " + std::string(method.name) +
                "\n\n- Footprint: " + std::string(method.card.footprint) +
                "\n- LOD: " + std::string(method.card.lod) + "\n- Taps: " + std::string(method.card.taps) +
                "\n- Source: " + std::string(method.card.source) + "\n";
    return text;
}

}  // namespace

int main() {
    nlohmann::json pages;
    pages["docs/cli.md"]["exit statuses"] = table_of_exit_statuses();
    pages["docs/filter-scenes.md"]["filter scenes"] = table_of_filter_scenes();
    pages["docs/random.md"]["kinds"] = table_of_kinds();
    pages["docs/suite.md"]["suite"] = suite_table(suite_manifest());
    pages["docs/suite.md"]["thorough suite"] = suite_table(thorough_manifest());
    pages["docs/texture-filters.md"]["cards"] = definition_cards();
    std::cout << pages << "\n";
}
