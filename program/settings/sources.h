/// Where settings come from: each source is one function, and precedence is one fold over them.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "program/settings/setting.h"
#include "program/toml/document.h"

namespace zproof {

/// std::getenv, or a test's own. nullptr: not set; what is empty counts as not set.
using Environment = std::function<const char*(const std::string& name)>;

/// zproof.toml, read.
struct SettingsFile {
    std::filesystem::path file;
    TomlValue document;
};

/// Which file and profile are wanted; empty: as ZPROOF_CONFIG and ZPROOF_PROFILE say, else the usual.
struct SettingsChoice {
    std::string file;  ///< "none": read none
    std::string profile;
};

/// The file that is chosen, else ZPROOF_CONFIG's, else zproof.toml of the current folder; nothing where there
/// is none. UsageError where it is malformed or has a key that is no setting, also in profiles that are not
/// chosen; ReportError where a file that was named cannot be read.
std::optional<SettingsFile> find_settings_file(const SettingsChoice& choice, const Environment& environment);

/// The profile that is chosen, else ZPROOF_PROFILE's, else the file's `profile`; empty for none.
std::string chosen_profile(const SettingsChoice& choice, const std::optional<SettingsFile>& file,
                           const Environment& environment);

SettingValues from_environment(const Environment& environment);  ///< ZPROOF_OUT and so on
SettingValues from_profile(const std::optional<SettingsFile>& file, const std::string& profile);
SettingValues from_file(const std::optional<SettingsFile>& file);
SettingValues from_ci_server(const Environment& environment);  ///< what CI and GITHUB_ACTIONS suggest

/// The word of the first source that has one, for each setting.
SettingValues strongest(const std::vector<SettingValues>& strongest_first);

/// Everything that is not on the command line: environment, then profile, then file, then the CI server.
SettingValues settings_here(const SettingsChoice& choice, const Environment& environment);

}  // namespace zproof
