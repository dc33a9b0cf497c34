#include "program/settings/sources.h"

#include <algorithm>
#include <charconv>
#include <sstream>

#include "frame/joined.h"
#include "program/nearest_word.h"
#include "program/toml/reader.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

constexpr const char* usual_file = "zproof.toml";

std::optional<std::string> read(const Environment& environment, const std::string& name) {
    const char* value = environment(name);
    return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>{value};
}

std::string flag_word(const std::string& text, const std::string& origin) {
    if (text == "1" || text == "true") return "true";
    if (text == "0" || text == "false") return "false";
    throw UsageError{origin + ": expected true, false, 1 or 0, found '" + text + "'"};
}

/// Beside the file: "waivers.toml" of ci/zproof.toml is ci/waivers.toml.
std::string beside(const fs::path& file, const std::string& word) {
    const fs::path folder = file.parent_path();
    return folder.empty() || fs::path{word}.is_absolute() ? word : (folder / word).generic_string();
}

/// A word of a list of paths may also be a name, such as that of a suite scene.
std::string beside_if_there(const fs::path& file, const std::string& word) {
    const std::string path = beside(file, word);
    std::error_code ignored;
    return fs::exists(path, ignored) ? path : word;
}

std::vector<std::string> texts_of(const TomlReader& table, const TomlValue& value, const std::string& key) {
    if (const auto* text = std::get_if<std::string>(&value.is)) return {*text};
    std::vector<std::string> texts;
    for (const TomlValue& one : table.items_of(value, key)) texts.push_back(table.text_of(one, key));
    return texts;
}

/// A wrong number is refused here, where file and line can be named together with what is right.
std::string number_of(const TomlReader& table, const Setting& setting, const TomlValue& value) {
    const auto* whole = std::get_if<std::int64_t>(&value.is);
    if (whole != nullptr && setting.range.contains(*whole)) return std::to_string(*whole);
    table.refuse(value, setting.name + ": " + in_words(setting.range) + ", found " +
                            (whole == nullptr ? kind_of(value) : std::to_string(*whole)) +
                            "; write such as: " + setting.name + " = " +
                            std::to_string(setting.range.such_as));
}

/// Checks a setting's number from the environment.
std::string number_of(const Setting& setting, const std::string& text) {
    std::int64_t number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc{} && stop == text.data() + text.size() && setting.range.contains(number))
        return text;
    const std::string name = environment_name(setting);
    throw UsageError{name + ": " + in_words(setting.range) + ", found '" + text +
                     "'; write such as: " + name + "=" + std::to_string(setting.range.such_as)};
}

/// The setting's value as it would be typed.
std::vector<std::string> words_of(const TomlReader& table, const Setting& setting, const TomlValue& value) {
    switch (setting.kind) {
        case Setting::Kind::number:
            return {number_of(table, setting, value)};
        case Setting::Kind::flag:
            if (const bool* truth = std::get_if<bool>(&value.is)) return {*truth ? "true" : "false"};
            table.refuse(value, setting.name + ": expected true or false, found " + kind_of(value));
        case Setting::Kind::list:
            return {joined(texts_of(table, value, setting.name), ",")};
        case Setting::Kind::path:
            return {beside(table.file(), table.text_of(value, setting.name))};
        case Setting::Kind::paths: {
            std::vector<std::string> words;
            for (const std::string& word : texts_of(table, value, setting.name))
                words.push_back(beside_if_there(table.file(), word));
            return words;
        }
        case Setting::Kind::text:
            if (const Day* day = std::get_if<Day>(&value.is)) return {in_words(*day)};
            return {table.text_of(value, setting.name)};
    }
    return {};
}

SettingValues assignments_in(const TomlReader& table) {
    SettingValues found;
    for (const Setting& setting : known_settings())
        if (const TomlValue* value = table.find(setting.name))
            found.push_back(
                {setting.name, words_of(table, setting, *value),
                 table.file() + ":" + std::to_string(value->line) + ":" + std::to_string(value->column)});
    return found;
}

TomlReader root_of(const SettingsFile& file) { return {file.file.string(), file.document}; }

/// Every key of the file, chosen or not, is a setting or a profile of settings.
void check(const SettingsFile& file) {
    const TomlReader root = root_of(file);
    std::vector<std::string> keys = setting_names();
    assignments_in(root);
    keys.insert(keys.end(), {"profile", "profiles"});
    root.allow_only(keys);
    keys.resize(keys.size() - 2);
    if (const TomlValue* profiles = root.find("profiles")) {
        const TomlReader by_name{root.file(), *profiles};
        for (const auto& [name, table] : by_name.entries()) {
            const TomlReader profile{root.file(), table};
            profile.allow_only(keys);
            assignments_in(profile);
        }
    }
}

bool is_said(const Environment& environment, const std::string& name) {
    const auto value = read(environment, name);
    return value && *value != "false" && *value != "0";
}

}  // namespace

std::optional<SettingsFile> find_settings_file(const SettingsChoice& choice, const Environment& environment) {
    std::string name = choice.file;
    if (name.empty()) name = read(environment, "ZPROOF_CONFIG").value_or("");
    std::error_code ignored;
    if (name == "none" || (name.empty() && !fs::exists(usual_file, ignored))) return std::nullopt;
    if (name.empty()) name = usual_file;
    SettingsFile file{name, read_toml(name)};
    check(file);
    return file;
}

std::string chosen_profile(const SettingsChoice& choice, const std::optional<SettingsFile>& file,
                           const Environment& environment) {
    if (!choice.profile.empty()) return choice.profile;
    if (const auto name = read(environment, "ZPROOF_PROFILE")) return *name;
    return file ? root_of(*file).text_or("profile", "") : "";
}

SettingValues from_environment(const Environment& environment) {
    SettingValues found;
    for (const Setting& setting : known_settings()) {
        const std::string origin = environment_name(setting);
        const auto value = read(environment, origin);
        if (!value) continue;
        std::vector<std::string> words{*value};
        if (setting.kind == Setting::Kind::number) words = {number_of(setting, *value)};
        if (setting.kind == Setting::Kind::flag) words = {flag_word(*value, origin)};
        if (setting.kind == Setting::Kind::paths) {
            words.clear();
            std::istringstream in{*value};
            for (std::string word; std::getline(in, word, ',');) words.push_back(word);
        }
        found.push_back({setting.name, std::move(words), origin});
    }
    return found;
}

SettingValues from_profile(const std::optional<SettingsFile>& file, const std::string& profile) {
    if (profile.empty()) return {};
    if (!file) throw UsageError{"profile '" + profile + "': there is no zproof.toml here that could have it"};
    const TomlReader root = root_of(*file);
    const TomlValue* profiles = root.find("profiles");
    std::vector<std::string> names;
    if (profiles != nullptr) {
        const TomlReader table{root.file(), *profiles};
        if (const TomlValue* chosen = table.find(profile)) return assignments_in({root.file(), *chosen});
        for (const auto& [name, value] : table.entries()) names.push_back(name);
    }
    throw UsageError{root.file() + ": there is no profile '" + profile + "'" + did_you_mean(profile, names) +
                     "; expected a table [profiles." + profile + "]"};
}

SettingValues from_file(const std::optional<SettingsFile>& file) {
    return file ? assignments_in(root_of(*file)) : SettingValues{};
}

SettingValues from_ci_server(const Environment& environment) {
    SettingValues found;
    if (is_said(environment, "CI")) found.push_back({"progress", {"lines"}, "CI"});
    if (is_said(environment, "GITHUB_ACTIONS"))
        found.push_back({"report", {"html,json,junit,github"}, "GITHUB_ACTIONS"});
    return found;
}

SettingValues strongest(const std::vector<SettingValues>& strongest_first) {
    SettingValues effective;
    for (const SettingValues& source : strongest_first)
        for (const SettingValue& one : source)
            if (std::ranges::find(effective, one.name, &SettingValue::name) == effective.end())
                effective.push_back(one);
    return effective;
}

SettingValues settings_here(const SettingsChoice& choice, const Environment& environment) {
    const auto file = find_settings_file(choice, environment);
    return strongest({from_environment(environment),
                      from_profile(file, chosen_profile(choice, file, environment)), from_file(file),
                      from_ci_server(environment)});
}

}  // namespace zproof
