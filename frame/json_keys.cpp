#include "frame/json_keys.h"

#include <algorithm>
#include <deque>
#include <nlohmann/json.hpp>
#include <tuple>
#include <vector>

#include "frame/frame_error.h"
#include "frame/printable.h"

namespace zproof {
namespace {

struct Key {
    std::string_view name;
    std::size_t byte = 0;
};

/// Behind the string that begins at `at`.
std::size_t end_of_string(std::string_view json, std::size_t at) {
    for (++at; at < json.size() && json[at] != '"'; ++at) at += json[at] == '\\';
    return std::min(at + 1, json.size());
}

/// The keys of the objects that are open.
class OpenObjects {
  public:
    void open() { first_.push_back(keys_.size()); }

    /// `word` with its quotes.
    void add(std::string_view word, std::size_t byte) {
        if (first_.empty()) return;
        if (word.find('\\') != std::string_view::npos) {
            const auto text = nlohmann::json::parse(word, nullptr, false);
            if (text.is_string()) word = unescaped_.emplace_back('"' + text.get<std::string>() + '"');
        }
        keys_.push_back({word, byte});
    }

    std::optional<RepeatedKey> close() {
        if (first_.empty()) return std::nullopt;
        const auto own = keys_.begin() + std::ptrdiff_t(first_.back());
        std::sort(own, keys_.end(), [](const Key& a, const Key& b) {
            return std::tie(a.name, a.byte) < std::tie(b.name, b.byte);
        });
        const auto twice =
            std::adjacent_find(own, keys_.end(), [](const Key& a, const Key& b) { return a.name == b.name; });
        if (twice != keys_.end())
            return RepeatedKey{
                std::next(twice)->byte,
                shortened(twice->name, 60) + " stands twice in its object; expected each key once"};
        keys_.erase(own, keys_.end());
        first_.pop_back();
        return std::nullopt;
    }

  private:
    std::vector<Key> keys_;
    std::vector<std::size_t> first_;     ///< of each object's keys
    std::deque<std::string> unescaped_;  ///< names that escapes spell
};

}  // namespace

std::optional<RepeatedKey> repeated_key(std::string_view json) {
    OpenObjects objects;
    for (std::size_t at = 0; at < json.size();) {
        if (json[at] == '{') objects.open();
        if (json[at] == '}')
            if (auto repeated = objects.close()) return repeated;
        if (json[at] != '"') {
            ++at;
            continue;
        }
        const std::size_t end = end_of_string(json, at);
        const std::size_t next = json.find_first_not_of(" \t\r\n", end);
        if (next != std::string_view::npos && json[next] == ':') objects.add(json.substr(at, end - at), at);
        at = end;
    }
    return std::nullopt;
}

void refuse_repeated_key(std::string_view json, const std::string& place) {
    if (const auto repeated = repeated_key(json))
        throw FrameError(place + ": byte " + std::to_string(repeated->byte) + ": " + repeated->why);
}

}  // namespace zproof
