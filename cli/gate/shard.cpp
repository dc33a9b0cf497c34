#include "cli/gate/shard.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "frame/number_text.h"
#include "math/sha256.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

int number_in(std::string_view text) {
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc{} && read.ptr == end ? value : 0;
}

std::size_t hash_of(const SceneSource& source) {
    const std::string digits = sha256_of(word_for(source)).substr(0, 8);
    std::uint32_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    return value;
}

const std::string planned_words = "the number of one of the plan's shards, such as 2 or 2/3";
const std::string hashed_words = "hash:NUMBER/COUNT, such as hash:2/3 (or a number, with --plan)";

/// "2/3"; nothing where it is none.
std::optional<Shard> one_of_many(std::string_view word) {
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const Shard shard{.number = number_in(word.substr(0, slash)), .count = number_in(word.substr(slash + 1))};
    if (shard.number < 1 || shard.number > shard.count || shard.count > most_shards) return std::nullopt;
    return shard;
}

std::optional<Shard> of_plan(std::string_view word) {
    const int number = number_in(word);
    if (number >= 1 && number <= most_shards) return Shard{.number = number, .count = 0};
    return one_of_many(word);
}

std::optional<Shard> by_hash(std::string_view word) {
    constexpr std::string_view method = "hash:";
    return word.starts_with(method) ? one_of_many(word.substr(method.size())) : std::nullopt;
}

/// Without a plan somebody must say how many there are.
Shard shard_counted(const Shard& shard, bool has_plan) {
    if (shard.count == 0 && !has_plan)
        throw UsageError{"--shard auto: " + shard.taken_from +
                         " comes without a count; make a plan (zproof plan)"};
    return shard;
}

}  // namespace

Shard shard_from(const std::string& word, bool has_plan, const Environment& environment) {
    if (word.empty() && !has_plan) return {};
    if (word == "auto") return shard_counted(shard_of_environment(environment), has_plan);
    const std::optional<Shard> shard = has_plan ? of_plan(word) : by_hash(word);
    if (shard) return *shard;
    throw UsageError{"--shard: expected " + (has_plan ? planned_words : hashed_words) +
                     ", or auto, with numbers from 1 to " + std::to_string(most_shards) + "; found '" + word +
                     "'"};
}

std::string word_of(const Shard& shard) {
    if (!shard.plan.empty()) return std::to_string(shard.number);
    return "hash:" + std::to_string(shard.number) + "/" + std::to_string(shard.count);
}

std::vector<SceneSource> share_of(std::vector<SceneSource> sources, Shard shard) {
    const auto count = std::size_t(shard.count), number = std::size_t(shard.number);
    for (SceneSource& source : sources)
        source.share.first = (number - 1 + count - hash_of(source) % count) % count,
        source.share.stride = count;
    return sources;
}

namespace {

std::string size_in_words(const Resolution& size) { return size_text(size.width, size.height); }

}  // namespace

Selection selection_of(const std::vector<SceneSource>& sources, Resolution resolution) {
    std::string words = size_in_words(resolution) + "\n";
    for (const SceneSource& source : sources)
        words += word_for(source) + (source.size ? " " + size_in_words(*source.size) : "") + "\n";
    return {sources.size(), sha256_of(words), {}};
}

}  // namespace zproof
