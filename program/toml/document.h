/// A TOML file as values that know their place in it, so that whatever is wrong can be pointed at.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compare/waivers/waiver.h"

namespace zproof {

struct TomlValue;
struct TomlEntry;
using TomlArray = std::vector<TomlValue>;
using TomlTable = std::vector<TomlEntry>;  ///< in the order of the file

struct TomlValue {
    std::variant<std::string, std::int64_t, double, bool, Day, TomlArray, TomlTable> is;
    int line = 1, column = 1;
};

struct TomlEntry {
    std::string key;
    TomlValue value;
};

/// The file's table. Throws UsageError, "FILE:LINE:COLUMN: ...", where it is no TOML or holds a time of day,
/// and ReportError where it cannot be read.
TomlValue read_toml(const std::filesystem::path& file);
TomlValue parse_toml(const std::string& text, const std::string& name);  ///< `name` stands for the file

}  // namespace zproof
