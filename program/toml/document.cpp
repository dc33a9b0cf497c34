#include "program/toml/document.h"

#include <toml++/toml.h>

#include <algorithm>

#include "frame/input_file.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

std::string place_of(const std::string& name, const toml::source_position& at) {
    return name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": ";
}

TomlValue value_of(const toml::node& node, const std::string& name);

TomlTable entries_of(const toml::table& table, const std::string& name) {
    TomlTable entries;
    for (const auto& [key, node] : table) entries.push_back({std::string{key.str()}, value_of(node, name)});
    std::ranges::stable_sort(entries, {}, [](const TomlEntry& entry) {
        return std::pair{entry.value.line, entry.value.column};
    });
    return entries;
}

TomlArray items_of(const toml::array& array, const std::string& name) {
    TomlArray items;
    for (const toml::node& node : array) items.push_back(value_of(node, name));
    return items;
}

decltype(TomlValue::is) meaning_of(const toml::node& node, const std::string& name) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* truth = node.as_boolean()) return truth->get();
    if (const auto* array = node.as_array()) return items_of(*array, name);
    if (const auto* table = node.as_table()) return entries_of(*table, name);
    if (const auto* date = node.as_date())
        return Day{std::chrono::year{int{date->get().year}}, std::chrono::month{date->get().month},
                   std::chrono::day{date->get().day}};
    throw UsageError{place_of(name, node.source().begin) +
                     "a time of day has no meaning here; expected a day such as 2026-04-10"};
}

TomlValue value_of(const toml::node& node, const std::string& name) {
    const toml::source_position at = node.source().begin;
    return {meaning_of(node, name), int(at.line), int(at.column)};
}

}  // namespace

TomlValue parse_toml(const std::string& text, const std::string& name) {
    try {
        return {entries_of(toml::parse(text, name), name), 1, 1};
    } catch (const toml::parse_error& e) {
        throw UsageError{place_of(name, e.source().begin) + std::string{e.description()}};
    }
}

TomlValue read_toml(const std::filesystem::path& file) {
    return parse_toml(read_input(file, {.words = "a TOML file"}), file.string());
}

}  // namespace zproof
