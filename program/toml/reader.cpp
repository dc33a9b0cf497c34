#include "program/toml/reader.h"

#include <algorithm>
#include <array>

#include "frame/did_you_mean.h"
#include "program/usage_error.h"

namespace zproof {

TomlReader::TomlReader(std::string file, const TomlValue& table) : file_(std::move(file)), table_(&table) {
    if (!std::holds_alternative<TomlTable>(table.is))
        refuse("expected a table { key = value, ... }, found " + kind_of(table));
}

const TomlValue* TomlReader::find(const std::string& key) const {
    const auto found = std::ranges::find(entries(), key, &TomlEntry::key);
    return found == entries().end() ? nullptr : &found->value;
}

const TomlValue& TomlReader::at(const std::string& key) const {
    if (const TomlValue* value = find(key)) return *value;
    refuse("the key '" + key + "' is missing");
}

std::string TomlReader::text(const std::string& key) const {
    const TomlValue& value = at(key);
    std::string text = text_of(value, key);
    if (text.empty()) refuse(value, key + ": expected a text that is not empty");
    return text;
}

std::string TomlReader::text_or(const std::string& key, const std::string& otherwise) const {
    return find(key) == nullptr ? otherwise : text(key);
}

Day TomlReader::day(const std::string& key) const {
    const TomlValue& value = at(key);
    if (const Day* day = std::get_if<Day>(&value.is)) return *day;
    if (const auto* text = std::get_if<std::string>(&value.is))
        if (const auto day = day_from(*text)) return *day;
    refuse(value, key + ": expected a day such as 2026-04-10, found " + kind_of(value));
}

void TomlReader::allow_only(std::span<const std::string> keys) const {
    for (const auto& [key, value] : entries())
        if (std::ranges::count(keys, key) == 0) {
            refuse(value, "unknown key '" + key + "'" + did_you_mean_or_all(key, keys));
        }
}

std::string TomlReader::text_of(const TomlValue& value, const std::string& key) const {
    if (const auto* text = std::get_if<std::string>(&value.is)) return *text;
    refuse(value, key + ": expected a text in quotes, found " + kind_of(value));
}

std::int64_t TomlReader::whole_of(const TomlValue& value, const std::string& key, std::int64_t most) const {
    const auto* whole = std::get_if<std::int64_t>(&value.is);
    if (whole != nullptr && *whole >= 0 && *whole <= most) return *whole;
    refuse(value, key + ": expected a whole number from 0 to " + std::to_string(most) + ", found " +
                      (whole == nullptr ? kind_of(value) : std::to_string(*whole)));
}

const TomlArray& TomlReader::items_of(const TomlValue& value, const std::string& key) const {
    const auto* items = std::get_if<TomlArray>(&value.is);
    if (items != nullptr && !items->empty()) return *items;
    refuse(value, key + ": expected a list with something in it, found " +
                      (items == nullptr ? kind_of(value) : std::string{"none"}));
}

void TomlReader::refuse(const TomlValue& at, const std::string& why) const {
    throw UsageError{file_ + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": " + why};
}

std::string kind_of(const TomlValue& value) {
    constexpr std::array<const char*, 7> kinds{
        "a text", "a whole number", "a decimal number", "true or false", "a day", "a list", "a table"};
    return kinds[value.is.index()];
}

}  // namespace zproof
