#include "filters/commands/precision_words.h"

#include <algorithm>
#include <charconv>

#include "filters/conformance/filter_precision_presets.h"
#include "program/nearest_word.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

struct Key {
    std::string name;
    double FilterPrecision::*value;
    double FilterPrecision::*other = nullptr;  ///< set as well
    double share = 1;                          ///< of the number, that the first is set to
};

const std::vector<Key>& keys() {
    static const std::vector<Key> all{
        {"arithmetic_bits", &FilterPrecision::arithmetic_bits},
        {"coordinate_bits", &FilterPrecision::coordinate_bits},
        {"displacement_px", &FilterPrecision::displacement_px},
        {"step_bits", &FilterPrecision::step_bits},
        {"place_bits", &FilterPrecision::place_bits},
        {"weight_bits", &FilterPrecision::weight_bits},
        {"split_bits", &FilterPrecision::split_bits},
        {"lod_bits", &FilterPrecision::lod_bits},
        {"lod_below", &FilterPrecision::lod_below},
        {"lod_above", &FilterPrecision::lod_above},
        // Vulkan 1.3, "Scale Factor Operation", admits 1.
        {"lod_slack", &FilterPrecision::lod_below, &FilterPrecision::lod_above, 0.5},
        {"tap_bits", &FilterPrecision::tap_bits},
        {"sum_bits", &FilterPrecision::sum_bits},
        {"texel_bits", &FilterPrecision::texel_bits},
        {"colour_bits", &FilterPrecision::colour_bits},
        {"code_error", &FilterPrecision::code_error}};
    return all;
}

/// A picture of 8-bit codes, each the nearest one.
constexpr std::string_view srgb8 = "output=srgb8";

double number(const std::string& word, const std::string& text) {
    double value = -1;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || !(value >= 0 && value <= 1000))
        throw UsageError{"--precision: '" + word + "': expected a number from 0 to 1000"};
    return value;
}

/// A word that is neither a key nor a preset.
[[noreturn]] void refuse(const std::string& word, const std::string& name) {
    std::vector<std::string> names;
    for (const Key& known : keys()) names.push_back(known.name);
    names.emplace_back(srgb8);
    for (const FilterPrecisionPreset& preset : filter_precision_presets()) names.emplace_back(preset.name);
    throw UsageError{"--precision: '" + word + "': no such preset or promise" + did_you_mean(name, names) +
                     " (see: zproof filters check --help)"};
}

}  // namespace

FilterPrecision filter_precision_from_words(const std::vector<std::string>& words) {
    FilterPrecision precision;
    for (const std::string& word : words) {
        const std::size_t equals = std::min(word.find('='), word.size());
        const std::string name = word.substr(0, equals);
        const auto key = std::ranges::find(keys(), name, &Key::name);
        if (const auto preset = preset_filter_precision(word)) {
            if (&word != &words.front())
                throw UsageError{"--precision: '" + word + "': a preset comes first, then keys: " + word +
                                 ",lod_bits=6"};
            precision = *preset;
            continue;
        }
        if (word == srgb8) {
            precision.code_error = 0.5;
            continue;
        }
        if (key == keys().end()) refuse(word, name);
        const double value = number(word, word.substr(std::min(equals + 1, word.size())));
        precision.*(key->value) = key->share * value;
        if (key->other != nullptr) precision.*(key->other) = value;
    }
    return precision;
}

}  // namespace zproof
