#include "renderers/vulkan_words.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "frame/joined.h"
#include "frame/precision_words.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

using oracle::IdSource;
using oracle::PlanesBy;
using oracle::Values;
using oracle::VulkanSettings;

constexpr std::string_view word_of(PlanesBy planes) { return planes == PlanesBy::z ? "z" : "distances"; }

constexpr std::string_view word_of(IdSource ids) {
    return ids == IdSource::as_there_is ? "any" : ids == IdSource::primitive ? "primitive" : "vertex";
}

constexpr std::string_view word_of(Values values) { return values == Values::none ? "none" : "all"; }

/// A key with one of its values.
struct VulkanWord {
    std::string_view key, value;
    void (*set)(VulkanSettings&);
    bool (*is_set)(const VulkanSettings&);  ///< and is not as usual
};

template <auto member, auto... values>
constexpr std::array<VulkanWord, sizeof...(values)> words_for(std::string_view key) {
    return {VulkanWord{key, word_of(values), [](VulkanSettings& s) { s.*member = values; },
                       [](const VulkanSettings& s) {
                           return s.*member == values && VulkanSettings{}.*member != values;
                       }}...};
}

std::vector<VulkanWord> all_words() {
    std::vector<VulkanWord> all;
    const auto add = [&](const auto& words) { all.insert(all.end(), words.begin(), words.end()); };
    using enum DepthFormat;
    add(words_for<&VulkanSettings::depth_format, float32, unorm24, unorm16>("depth_format"));
    add(words_for<&VulkanSettings::depth_buffer, DepthBuffer::reversed_z, DepthBuffer::standard_z>(
        "depth_buffer"));
    add(words_for<&VulkanSettings::planes, PlanesBy::z, PlanesBy::distances>("planes"));
    add(words_for<&VulkanSettings::ids, IdSource::as_there_is, IdSource::primitive, IdSource::vertex>("ids"));
    add(words_for<&VulkanSettings::attributes, Values::none, Values::all>("attributes"));
    return all;
}

std::string text_of(const VulkanWord& word) { return std::string(word.key) + "=" + std::string(word.value); }

}  // namespace

VulkanSettings vulkan_settings_from_words(const std::string& words) {
    VulkanSettings settings;
    const std::vector<VulkanWord> permitted = all_words();
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find(':', at + 1), words.size());
        const std::string typed = words.substr(at + 1, end - at - 1);
        const auto found = std::ranges::find(permitted, typed, text_of);
        if (found == permitted.end())
            throw UsageError{"renderer 'vulkan" + words + "': '" + typed + "': expected one of " +
                             joined(permitted, ", ", text_of)};
        found->set(settings);
        at = end;
    }
    return settings;
}

std::string words_of(const VulkanSettings& settings) {
    std::string words;
    for (const VulkanWord& word : all_words())
        if (word.is_set(settings)) words += ":" + text_of(word);
    return words;
}

std::string promise_in_words(const oracle::VulkanDevice& device) {
    return std::to_string(device.subpixel_bits) + " sub-pixel bits; depth in " +
           joined(device.depth_formats, ", ", [](DepthFormat format) { return word_of(format); }) + "; " +
           joined(device.sample_counts, ", ", [](int count) { return std::to_string(count); }) +
           " samples; images up to " + std::to_string(device.largest_side_px) +
           " px; textures: " + std::to_string(device.subtexel_bits) + " sub-texel, " +
           std::to_string(device.mipmap_bits) + " mipmap bits";
}

}  // namespace zproof
