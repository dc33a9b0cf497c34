/// Reads one table of a TOML file key by key. Whatever is wrong is thrown as UsageError: file, line, column,
/// what was expected and what was found.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "program/toml/document.h"

namespace zproof {

class TomlReader {
  public:
    /// The value must be a table and outlive this object.
    TomlReader(std::string file, const TomlValue& table);

    const TomlValue* find(const std::string& key) const;  ///< nullptr: not there
    const TomlValue& at(const std::string& key) const;    ///< it must be there

    std::string text(const std::string& key) const;  ///< not empty
    std::string text_or(const std::string& key, const std::string& otherwise) const;
    Day day(const std::string& key) const;

    /// Refuses every key that is not among these, with the one that was probably meant.
    void allow_only(std::span<const std::string> keys) const;

    std::string text_of(const TomlValue& value, const std::string& key) const;
    std::int64_t whole_of(const TomlValue& value, const std::string& key, std::int64_t most) const;  ///< >= 0
    const TomlArray& items_of(const TomlValue& value, const std::string& key) const;

    /// "FILE:LINE:COLUMN: why".
    [[noreturn]] void refuse(const TomlValue& at, const std::string& why) const;
    /// Refuses the table itself.
    [[noreturn]] void refuse(const std::string& why) const { refuse(*table_, why); }

    const std::string& file() const { return file_; }
    const TomlTable& entries() const { return std::get<TomlTable>(table_->is); }
    int line() const { return table_->line; }

  private:
    std::string file_;
    const TomlValue* table_;
};

/// "a text", "a whole number", "a list", ...
std::string kind_of(const TomlValue& value);

}  // namespace zproof
