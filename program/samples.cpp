#include "program/samples.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "program/usage_error.h"
#include "scenes/standard_samples.h"

namespace zproof {
namespace {

constexpr std::string_view pattern_word = "standard:";

[[noreturn]] void refuse(const std::string& word, const std::string& what) {
    throw UsageError{"--sample " + word + ": " + what};
}

/// All of the text as a number.
template <class Number>
std::optional<Number> number_from(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// The samples that the words after "standard:" name.
std::vector<Sample> pattern_from(const std::string& word, std::string_view rest) {
    const std::size_t colon = rest.find(':');
    const auto count = number_from<int>(rest.substr(0, colon));
    std::vector<Sample> samples = standard_samples(count.value_or(0));
    if (samples.empty()) refuse(word, "a standard pattern has 1, 2, 4, 8 or 16 samples");
    if (colon == rest.npos) return samples;
    const auto index = number_from<int>(rest.substr(colon + 1));
    if (!index || *index < 0 || *index >= *count)
        refuse(word, "expected the index of a sample, 0 to " + std::to_string(*count - 1));
    return {samples[std::size_t(*index)]};
}

}  // namespace

std::vector<Sample> samples_from_word(const std::string& word) {
    if (word.starts_with(pattern_word))
        return pattern_from(word, std::string_view{word}.substr(pattern_word.size()));
    const std::size_t comma = word.find(',');
    if (comma == word.npos) refuse(word, "expected DX,DY in pixels, standard:COUNT or standard:COUNT:INDEX");
    const std::string_view text = word;
    const auto x = number_from<double>(text.substr(0, comma)),
               y = number_from<double>(text.substr(comma + 1));
    if (!x || !y || !is_sample_offset({*x, *y}))
        refuse(word,
               "expected an offset from the pixel's centre, each a multiple of 1/256 px from -0.5 to "
               "below 0.5, e.g. -0.125,0.375");
    return {Sample{.offset_px = {*x, *y}}};
}

std::vector<View> at_samples(const std::vector<View>& views, const std::vector<Sample>& samples) {
    std::vector<View> all;
    for (const View& view : views)
        for (const Sample& sample : samples) all.emplace_back(view).sample = sample;
    return all;
}

bool is_centre(const Sample& sample) { return sample_word(sample).empty(); }

std::string shown_name(const View& view) {
    const auto& [index, count, offset_px] = view.sample;
    if (is_centre(view.sample)) return view.name;
    if (count > 1) return view.name + ".sample-" + std::to_string(index);
    return view.name + ".at_" + px_text(offset_px.x) + "_" + px_text(offset_px.y);
}

std::string sample_note(const Sample& sample) {
    if (is_centre(sample)) return "";
    const std::string place = "(" + px_text(sample.offset_px.x) + ", " + px_text(sample.offset_px.y) + ")";
    const std::string which = sample.count > 1 ? "sample " + std::to_string(sample.index) + " of 0 to " +
                                                     std::to_string(sample.count - 1) + ", "
                                               : "";
    return "sampled beside the pixels' centres: " + which + place + " px, x right, y down";
}

}  // namespace zproof
