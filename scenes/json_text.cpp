#include "scenes/json_text.h"

#include "frame/json_keys.h"
#include "scenes/limits.h"

namespace zproof {
namespace {

/// Counts brackets and commas outside strings; malformed text is left to the parser.
class Extent {
  public:
    Extent(const std::filesystem::path& file, std::string_view text) : file_(file), text_(text) {}

    void check() {
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '"') skip_string();
            if (c == '[' || c == '{') check_limit(++depth_, limits::json_depth, "nested too deep", "levels");
            if (c == '[' || c == '{' || c == ',')
                check_limit(++values_, limits::json_values, "too many values", "values");
            if (c == '{') check_limit(++objects_, limits::json_objects, "too many objects", "objects");
            if ((c == ']' || c == '}') && depth_ > 0) --depth_;
        }
    }

  private:
    [[noreturn]] void refuse_here(const std::string& why) const {
        refuse(file_, "byte " + std::to_string(at_), why);
    }

    void check_limit(std::size_t count, std::size_t limit, const std::string& fault,
                     const std::string& of) const {
        if (count > limit) refuse_here(fault + ": at most " + std::to_string(limit) + " " + of);
    }

    /// Goes to the quote that closes a string. Whoever reads a name up to the character 0 would cut it.
    void skip_string() {
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            if (text_[at_] != '\\') continue;
            if (text_.substr(at_, 6) == "\\u0000") refuse_here("expected text without the character 0");
            ++at_;
        }
    }

    const std::filesystem::path& file_;
    std::string_view text_;
    std::size_t at_ = 0, depth_ = 0, values_ = 0, objects_ = 0;
};

/// nlohmann's message without its "[json.exception...]" tag.
std::string plain(const std::string& what) {
    const std::size_t tag = what.find("] ");
    return tag == std::string::npos ? what : what.substr(tag + 2);
}

}  // namespace

nlohmann::json parse_json(const std::filesystem::path& file, std::string_view text) {
    Extent(file, text).check();
    try {
        nlohmann::json parsed = nlohmann::json::parse(text);
        if (const auto repeated = repeated_key(text))
            refuse(file, "byte " + std::to_string(repeated->byte), repeated->why);
        return parsed;
    } catch (const nlohmann::json::exception& error) {
        refuse(file, "JSON", plain(error.what()) + "; mend or export the file again");
    }
}

}  // namespace zproof
