#include "cli/gate/shard.h"

#include <charconv>

#include "cli/usage_error.h"
#include "math/sha256.h"

namespace zproof {
namespace {

constexpr int most_shards = 10'000;

int number_in(std::string_view text) {
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc{} && read.ptr == end ? value : 0;
}

int number_of(const SceneSource& source, int count) {
    const std::string digits = sha256_of(word_for(source)).substr(0, 8);
    std::uint32_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    return 1 + int(value % std::uint32_t(count));
}

}  // namespace

Shard shard_from(const std::string& word) {
    constexpr std::string_view method = "hash:";
    const std::size_t slash = word.find('/');
    if (word.starts_with(method) && slash != std::string::npos) {
        const std::string_view text = word;
        const Shard shard{number_in(text.substr(method.size(), slash - method.size())),
                          number_in(text.substr(slash + 1))};
        if (shard.number >= 1 && shard.number <= shard.count && shard.count <= most_shards) return shard;
    }
    throw UsageError{"--shard: expected hash:NUMBER/COUNT such as hash:2/3, with 1 <= NUMBER <= COUNT <= " +
                     std::to_string(most_shards) + "; found '" + word + "'"};
}

std::vector<SceneSource> share_of(std::vector<SceneSource> sources, Shard shard) {
    if (shard.count > 1)
        std::erase_if(sources,
                      [&](const SceneSource& s) { return number_of(s, shard.count) != shard.number; });
    return sources;
}

namespace {

std::string size_in_words(const Resolution& size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

Selection selection_of(const std::vector<SceneSource>& sources, Resolution resolution) {
    std::string words = size_in_words(resolution) + "\n";
    for (const SceneSource& source : sources)
        words += word_for(source) + (source.size ? " " + size_in_words(*source.size) : "") + "\n";
    return {sources.size(), sha256_of(words), {}};
}

}  // namespace zproof
