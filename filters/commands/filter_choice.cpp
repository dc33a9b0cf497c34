#include "filters/commands/filter_choice.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include "filters/commands/level_files.h"
#include "filters/methods/catalogue.h"
#include "frame/joined.h"
#include "program/nearest_word.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

using rasterizer::Texturing;
using texture::Decoding;
using texture::Derivatives;
using texture::MipKernel;
using texture::SatStorage;

/// One key: sets what the text says, or returns false where it cannot be that.
struct MethodSetting {
    std::string key, expects, meaning;
    bool (*set)(Texturing&, const std::string& text);
};

template <class Number>
std::optional<Number> number(const std::string& text, Number low, Number high) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_whole_text = error == std::errc{} && end == text.data() + text.size();
    return is_whole_text && value >= low && value <= high ? std::optional{value} : std::nullopt;
}

bool set_number(auto& value, const std::string& text, auto low, auto high) {
    const auto found = number(text, low, high);
    if (found) value = *found;
    return found.has_value();
}

template <class T, std::size_t n>
bool set_word(T& value, const std::string& text, const std::array<std::pair<std::string_view, T>, n>& words) {
    const auto found = std::ranges::find(words, text, &std::pair<std::string_view, T>::first);
    if (found != words.end()) value = found->second;
    return found != words.end();
}

constexpr std::array<std::pair<std::string_view, MipKernel>, 4> mip_words{
    {{"box", MipKernel::box},
     {"polyphase", MipKernel::polyphase},
     {"lanczos3", MipKernel::lanczos3},
     {"kaiser3", MipKernel::kaiser3}}};
constexpr std::array<std::pair<std::string_view, Decoding>, 2> decoding_words{
    {{"before", Decoding::before_filtering}, {"after", Decoding::after_filtering}}};
constexpr std::array<std::pair<std::string_view, SatStorage>, 4> sat_words{
    {{"integer", SatStorage::integer},
     {"float64", SatStorage::float64},
     {"float32", SatStorage::float32},
     {"float32-less-mean", SatStorage::float32_less_mean}}};
constexpr std::array<std::pair<std::string_view, Derivatives>, 2> derivative_words{
    {{"analytic", Derivatives::analytic}, {"quad", Derivatives::quad_differences}}};
constexpr std::array<std::pair<std::string_view, rasterizer::UvInterpolation>, 2> uv_words{
    {{"perspective", rasterizer::UvInterpolation::perspective},
     {"affine", rasterizer::UvInterpolation::affine}}};

const std::vector<MethodSetting>& method_settings() {
    static const std::vector<MethodSetting> all{
        {"bias", "a number from -16 to 16", "added to the LOD before it is clamped",
         [](Texturing& t, const std::string& s) { return set_number(t.options.lod_bias, s, -16.0, 16.0); }},
        {"lod-min", "a number from 0 to 1000", "least LOD",
         [](Texturing& t, const std::string& s) { return set_number(t.options.lod_min, s, 0.0, 1000.0); }},
        {"lod-max", "a number from 0 to 1000", "greatest LOD",
         [](Texturing& t, const std::string& s) { return set_number(t.options.lod_max, s, 0.0, 1000.0); }},
        {"max-anisotropy", "a whole number from 1 to 64", "of anisotropic methods (16)",
         [](Texturing& t, const std::string& s) { return set_number(t.options.max_anisotropy, s, 1, 64); }},
        {"n", "a whole number from 1 to 64", "sub-quads, strips or samples along one side (4)",
         [](Texturing& t, const std::string& s) { return set_number(t.options.subdivisions, s, 1, 64); }},
        {"spp", "a whole number from 1 to 1024", "samples a pixel, of stochastic methods (1)",
         [](Texturing& t, const std::string& s) { return set_number(t.options.samples, s, 1, 1024); }},
        {"seed", "a whole number from 0 to 4294967295", "of the noise of stochastic methods (0)",
         [](Texturing& t, const std::string& s) {
             return set_number(t.options.seed, s, std::uint32_t{0}, std::uint32_t{0xFFFF'FFFF});
         }},
        {"mip", "box, polyphase, lanczos3 or kaiser3", "how smaller levels are made (polyphase)",
         [](Texturing& t, const std::string& s) { return set_word(t.options.mip_kernel, s, mip_words); }},
        {"levels", "a file with mip levels, or a name with {level} in it of which level 1 exists",
         "levels 1 and on, instead of made ones",
         [](Texturing& t, const std::string& s) {
             t.options.given_levels = levels_from_files(s);
             return t.options.given_levels != nullptr;
         }},
        {"sat", "integer, float64, float32 or float32-less-mean", "how summed-area tables are kept (float64)",
         [](Texturing& t, const std::string& s) { return set_word(t.options.sat_storage, s, sat_words); }},
        {"decode", "before or after",
         "after: sRGB codes are filtered, the wrong way, for comparison (before)",
         [](Texturing& t, const std::string& s) { return set_word(t.options.decoding, s, decoding_words); }},
        {"derivatives", "analytic or quad", "quad: differences within 2 x 2 pixels",
         [](Texturing& t, const std::string& s) { return set_word(t.derivatives, s, derivative_words); }},
        {"uv", "perspective or affine", "affine: the wrong way, for comparison",
         [](Texturing& t, const std::string& s) { return set_word(t.uv, s, uv_words); }},
    };
    return all;
}

std::vector<std::string> name_and_settings(const std::string& word) {
    std::vector<std::string> parts;
    std::istringstream in{word};
    for (std::string part; std::getline(in, part, ':');) parts.push_back(part);
    return parts;
}

const texture::Method& method_called(const std::string& name) {
    if (const texture::Method* method = texture::find_method(name)) return *method;
    if (const study::OtherSampler* other = study::find_other_sampler(name)) return other->method;
    std::vector<std::string> names;
    for (const texture::Method& method : texture::methods()) names.push_back(method.name);
    for (const study::OtherSampler& other : study::other_samplers()) names.push_back(other.method.name);
    throw UsageError{"filter '" + name + "': no such method" + did_you_mean(name, names) +
                     " (known: " + joined(names) + ")"};
}

void apply(Texturing& texturing, const std::string& part, const std::string& word) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string key = part.substr(0, equals), text = part.substr(std::min(equals + 1, part.size()));
    const auto setting = std::ranges::find(method_settings(), key, &MethodSetting::key);
    if (part.empty()) throw UsageError{"filter '" + word + "': nothing stands between two colons"};
    if (setting == method_settings().end()) {
        std::vector<std::string> keys;
        for (const MethodSetting& known : method_settings()) keys.push_back(known.key);
        throw UsageError{"filter '" + word + "': unknown setting '" + key + "'" + did_you_mean(key, keys) +
                         " (see: zproof render --help)"};
    }
    if (!setting->set(texturing, text))
        throw UsageError{"filter '" + word + "': " + key + ": expected " + setting->expects + ", found '" +
                         text + "'"};
}

void require_heeded(const study::OtherSampler& other, const std::string& part, const std::string& word) {
    std::string heeded;
    for (const std::string& key : other.settings) {
        if (part.starts_with(key + "=")) return;
        heeded += (heeded.empty() ? "" : ", ") + key;
    }
    throw UsageError{"filter '" + word + "': '" + part + "': of this sampler of others one sets only " +
                     heeded};
}

}  // namespace

FilterChoice filter_choice(const std::string& word) {
    FilterChoice choice = study_choice(word);
    if (choice.other != nullptr)
        throw UsageError{"filter '" + word + "': a sampler of others draws only in 'zproof filters run'"};
    return choice;
}

FilterChoice study_choice(const std::string& word) {
    const std::vector<std::string> parts = name_and_settings(word);
    FilterChoice choice{word, {.method = method_called(parts.empty() ? "" : parts[0])}};
    choice.other = study::find_other_sampler(choice.texturing.method.name);
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (choice.other != nullptr) require_heeded(*choice.other, parts[i], word);
    for (std::size_t i = 1; i < parts.size(); ++i) apply(choice.texturing, parts[i], word);
    const texture::FilterOptions& options = choice.texturing.options;
    if (options.lod_min > options.lod_max)
        throw UsageError{"filter '" + word + "': lod-min lies above lod-max"};
    if (options.given_levels && options.decoding == Decoding::after_filtering)
        throw UsageError{"filter '" + word +
                         "': decode=after: expected without levels=, which are linear light"};
    return choice;
}

std::string filter_settings_help() {
    constexpr std::size_t longest_key = std::string_view{"max-anisotropy"}.size();
    std::string help;
    for (const MethodSetting& setting : method_settings())
        help += "  " + setting.key + std::string(longest_key + 2 - setting.key.size(), ' ') +
                setting.expects + "; " + setting.meaning + "\n";
    return help;
}

}  // namespace zproof
