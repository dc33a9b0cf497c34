/// Settings: what an option of the command line says, said elsewhere. One table names them all.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zproof {

/// What a whole number may be, and one that it may well be.
struct WholeRange {
    std::int64_t least = 0, most = 0, such_as = 0;

    bool contains(std::int64_t number) const { return least <= number && number <= most; }
};

struct Setting {
    enum class Kind {
        text,
        number,  ///< a whole one; its option takes the same range
        flag,    ///< true or false
        list,    ///< of texts; in the environment separated by commas
        path,    ///< a file; in zproof.toml relative to its folder
        paths,   ///< a list; each relative to zproof.toml's folder where there is such a file
    };
    std::string name;  ///< "time-limit": the key in zproof.toml, and the option's name
    Kind kind = Kind::text;
    WholeRange range{};  ///< of a number
};

/// Every setting, in the order in which `zproof doctor` lists them.
std::span<const Setting> known_settings();
std::vector<std::string> setting_names();

/// "expected a whole number from 1 to 32768".
std::string in_words(const WholeRange& range);

std::string environment_name(const Setting& setting);  ///< "ZPROOF_TIME_LIMIT"
std::string option_name(const std::string& setting);   ///< "--time-limit"; of scenes, "SCENE"

/// What a source says of a setting.
struct SettingValue {
    std::string name;
    std::vector<std::string> words;  ///< as they would be typed after the option; of a flag "true" or "false"
    std::string origin;              ///< "ZPROOF_OUT", "zproof.toml:3:7"
};
using SettingValues = std::vector<SettingValue>;

}  // namespace zproof
