/// JSON from strangers: text, and values that know where they stand.
#pragma once

#include <algorithm>
#include <filesystem>
#include <glm/glm.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "scenes/refusal.h"

namespace zproof {

/// Parses the text; depth and numbers of values and objects are bounded before any parser recurses or
/// allocates. Throws SceneError, naming the file and the byte or line, for text that is not JSON, is beyond
/// limits, escapes the character 0 or has a key twice in one object.
nlohmann::json parse_json(const std::filesystem::path& file, std::string_view text);

/// A value with the place where it stands, so that every error can name it.
class LocatedValue {
  public:
    LocatedValue(const std::filesystem::path& file, const nlohmann::json& value, std::string pointer)
        : file_(file), value_(value), pointer_(std::move(pointer)) {}

    /// Text that begins with "expected" goes on with what was found, where that is a single value.
    [[noreturn]] void fail(const std::string& text) const {
        const bool shows_value = text.starts_with("expected") && !value_.is_structured();
        refuse(file_, pointer_.empty() ? "/" : pointer_,
               shows_value ? text + ", found " + value_.dump().substr(0, 60) : text);
    }

    const nlohmann::json& value() const { return value_; }
    bool has(const char* key) const { return value_.contains(key); }

    /// The member, which must be there.
    LocatedValue at(const char* key) const {
        if (!has(key)) fail(std::string("\"") + key + "\" is missing");
        return {file_, value_.at(key), pointer_ + "/" + key};
    }

    LocatedValue at(std::size_t index) const {
        return {file_, value_.at(index), pointer_ + "/" + std::to_string(index)};
    }

    /// Throws for a member that is not among the keys.
    void allow(std::initializer_list<const char*> keys) const {
        if (!value_.is_object()) fail("expected an object");
        std::string list;
        for (const char* key : keys) list += (list.empty() ? "" : ", ") + std::string(key);
        for (const auto& member : value_.items())
            if (std::find_if(keys.begin(), keys.end(),
                             [&](const char* key) { return member.key() == key; }) == keys.end())
                refuse(file_, pointer_ + "/" + member.key().substr(0, 60),
                       "unknown key; allowed here: " + list);
    }

    std::string text() const {
        if (!value_.is_string()) fail("expected a string");
        return value_.get<std::string>();
    }

    double number() const {
        if (!value_.is_number()) fail("expected a number");
        return value_.get<double>();
    }

    /// An array of `size` numbers.
    const nlohmann::json& numbers(std::size_t size) const {
        if (!value_.is_array() || value_.size() != size)
            fail("expected an array of " + std::to_string(size) + " numbers");
        for (std::size_t i = 0; i < size; ++i) at(i).number();
        return value_;
    }

    glm::dvec3 vector() const {
        return {numbers(3)[0].get<double>(), value_[1].get<double>(), value_[2].get<double>()};
    }

  private:
    const std::filesystem::path& file_;
    const nlohmann::json& value_;
    std::string pointer_;
};

}  // namespace zproof
