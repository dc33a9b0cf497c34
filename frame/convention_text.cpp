#include "frame/convention_text.h"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

#include "frame/convention_presets.h"
#include "frame/did_you_mean.h"
#include "frame/found_text.h"
#include "frame/frame_error.h"
#include "frame/input_file.h"
#include "frame/json_keys.h"
#include "frame/joined.h"

namespace zproof {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
using Words = std::span<const std::pair<std::string_view, T>>;

constexpr std::pair<std::string_view, IdCoding> codings[] = {{"integer", IdCoding::integer},
                                                             {"float", IdCoding::real},
                                                             {"rgb", IdCoding::rgb},
                                                             {"bgr", IdCoding::bgr}};
constexpr std::pair<std::string_view, BackgroundBy> deciders[] = {{"id", BackgroundBy::id},
                                                                  {"depth", BackgroundBy::depth}};
constexpr std::pair<std::string_view, RowOrder> row_orders[] = {{"top_first", RowOrder::top_first},
                                                                {"bottom_first", RowOrder::bottom_first}};
constexpr std::pair<std::string_view, DepthKind> depth_kinds[] = {
    {"camera", DepthKind::camera},
    {"ray_length", DepthKind::ray_length},
    {"ray_length_from_near", DepthKind::ray_length_from_near},
    {"ndc_z", DepthKind::ndc_z},
    {"window_z", DepthKind::window_z},
    {"reversed_z", DepthKind::reversed_z},
    {"inverse", DepthKind::inverse},
    {"disparity", DepthKind::disparity}};

// Each function below stores a value where it fits; false: it does not.

template <class T>
bool store_word(T& to, const Json& value, Words<T> words) {
    for (const auto& [word, meaning] : words)
        if (value == word) return to = meaning, true;
    return false;
}

bool store_name(std::string& to, const Json& value) {
    if (!value.is_string() || value.get<std::string>().empty()) return false;
    return to = value.get<std::string>(), true;
}

bool store_positive(double& to, const Json& value) {
    if (!value.is_number() || !(value.get<double>() > 0) || std::isinf(value.get<double>())) return false;
    return to = value.get<double>(), true;
}

bool store_base(Convention& to, const Json& value) {
    if (!value.is_number_unsigned() || value > std::numeric_limits<std::uint32_t>::max()) return false;
    return to.id_base = value.get<std::uint32_t>(), true;
}

bool store_id_background(Convention& to, const Json& value) {
    if (value == "largest") return to.id_background.reset(), true;
    constexpr std::int64_t largest = std::numeric_limits<std::uint32_t>::max();
    if (value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t(largest)) return false;
    if (!value.is_number_integer() || value < -largest || value > largest) return false;
    return to.id_background = value.get<std::int64_t>(), true;
}

bool add_background_depth(Convention& to, const Json& value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (value == "far") return to.far_is_background = true;
    if (value.is_number())
        to.background_depths.push_back(value.get<double>());
    else if (value == "nan")
        to.background_depths.push_back(std::numeric_limits<double>::quiet_NaN());
    else if (value == "infinity" || value == "-infinity")
        to.background_depths.push_back(value == "infinity" ? infinity : -infinity);
    else
        return false;
    return true;
}

bool store_background_depths(Convention& to, const Json& value) {
    to.background_depths.clear();
    to.far_is_background = false;
    if (!value.is_array()) return add_background_depth(to, value);
    for (const Json& one : value)
        if (!add_background_depth(to, one)) return false;
    return true;
}

struct ConventionKey {
    std::string_view name, expected;
    bool (*store)(Convention& to, const Json& value);
};

constexpr auto convention_keys = std::to_array<ConventionKey>({
    {"id_channel", "a channel's name",
     [](Convention& c, const Json& v) { return store_name(c.id_channel, v); }},
    {"depth_channel", "a channel's name",
     [](Convention& c, const Json& v) { return store_name(c.depth_channel, v); }},
    {"id_coding", "integer, float, rgb or bgr",
     [](Convention& c, const Json& v) { return store_word(c.id_coding, v, Words<IdCoding>(codings)); }},
    {"id_base", "a whole number from 0 to 4294967295", store_base},
    {"id_background", "a whole number or largest", store_id_background},
    {"background_by", "id or depth",
     [](Convention& c, const Json& v) {
         return store_word(c.background_by, v, Words<BackgroundBy>(deciders));
     }},
    {"rows", "top_first or bottom_first",
     [](Convention& c, const Json& v) { return store_word(c.rows, v, Words<RowOrder>(row_orders)); }},
    {"depth_kind",
     "camera, ray_length, ray_length_from_near, ndc_z, window_z, reversed_z, inverse or disparity",
     [](Convention& c, const Json& v) { return store_word(c.depth_kind, v, Words<DepthKind>(depth_kinds)); }},
    {"depth_coding", "float or integer",
     [](Convention& c, const Json& v) {
         c.depth_is_whole = v == "integer";
         return c.depth_is_whole || v == "float";
     }},
    {"depth_scale", "a number above 0",
     [](Convention& c, const Json& v) { return store_positive(c.depth_scale, v); }},
    {"baseline", "a number above 0",
     [](Convention& c, const Json& v) { return store_positive(c.baseline.emplace(), v); }},
    {"depth_background", "numbers, nan, infinity, -infinity or far", store_background_depths},
});

/// Where a text stands, and what it says wrong.
[[noreturn]] void refuse_key(const std::string& place, const std::string& key, const std::string& why) {
    throw FrameError(place + ": /" + key + ": " + why);
}

void store(Convention& to, const std::string& name, const Json& value, const std::string& place) {
    std::vector<std::string> known;
    for (const ConventionKey& key : convention_keys) {
        known.emplace_back(key.name);
        if (key.name != name) continue;
        if (!key.store(to, value))
            refuse_key(place, name, "expected " + std::string(key.expected) + ", found " + found_text(value));
        return;
    }
    refuse_key(place, name, "unknown key" + did_you_mean_or_all(name, known));
}

/// Facts that only make sense together.
void check(const Convention& convention, const std::string& place) {
    const bool is_disparity = convention.depth_kind == DepthKind::disparity;
    if (is_disparity != convention.baseline.has_value())
        refuse_key(
            place, "baseline",
            is_disparity ? "missing; a disparity has one, in scene units" : "only a disparity has one");
    if (convention.id_coding == IdCoding::real && !convention.id_background &&
        convention.background_by == BackgroundBy::id)
        refuse_key(place, "id_background",
                   "missing; floats have no largest id, so say which number is background");
    const DepthKind kind = convention.depth_kind;
    if (convention.depth_is_whole && kind != DepthKind::camera)
        refuse_key(
            place, "depth_coding",
            "integer: steps of such a depth differ from pixel to pixel; expected depth_kind=camera, or "
            "float and a promise that holds them");
    if (convention.far_is_background &&
        (kind == DepthKind::ray_length || kind == DepthKind::ray_length_from_near))
        refuse_key(place, "depth_background", "far: the far plane has no one ray length; expected a number");
}

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);) parts.push_back(part);
    return parts;
}

/// The name and the value of "NAME=VALUE".
std::pair<std::string, std::string> assignment(const std::string& part, const std::string& place) {
    const std::size_t sign = part.find('=');
    if (sign == std::string::npos) throw FrameError(place + ": expected KEY=VALUE, found '" + part + "'");
    return {part.substr(0, sign), part.substr(sign + 1)};
}

Json number_or_word(const std::string& text) {
    const Json number = Json::parse(text, nullptr, false);
    return number.is_number() ? number : Json(text);
}

/// "0|1e10" is a list. Channels may be called 3, so they are never numbers.
Json value_of(const std::string& key, const std::string& text) {
    if (key.ends_with("_channel")) return text;
    if (text.find('|') == std::string::npos) return number_or_word(text);
    Json list = Json::array();
    for (const std::string& part : split(text, '|')) list.push_back(number_or_word(part));
    return list;
}

void store_assignments(Convention& to, std::span<const std::string> parts, const std::string& place) {
    for (const std::string& part : parts) {
        const auto [key, value] = assignment(part, place);
        store(to, key, value_of(key, value), place);
    }
}

const ConventionPreset* preset_named(const std::string& name) {
    for (const ConventionPreset& preset : convention_presets())
        if (preset.name == name) return &preset;
    return nullptr;
}

Convention convention_of(const ConventionPreset& preset) {
    Convention convention;
    store_assignments(convention, split(std::string(preset.keys), ','), std::string(preset.name));
    return convention;
}

Convention from_word(const std::string& word, const std::string& place) {
    std::vector<std::string> parts = split(word, ',');
    Convention convention;
    if (const ConventionPreset* preset = preset_named(parts.front())) {
        convention = convention_of(*preset);
        parts.erase(parts.begin());
    } else if (parts.front().find('=') == std::string::npos) {
        throw FrameError(place + ": expected one of " + joined(convention_names()) +
                         ", KEY=VALUE,... or a JSON file" + did_you_mean(parts.front(), convention_names()));
    }
    store_assignments(convention, parts, place);
    return convention;
}

Convention from_file(const std::string& file) {
    constexpr std::size_t longest = 1 << 16;
    const std::string text = read_input(file, {.words = "a JSON file"});
    if (text.size() > longest) throw FrameError(file + ": more than 64 KiB; a convention is a few keys");
    refuse_repeated_key(text, file);
    Json object = Json::parse(text, nullptr, false);
    if (!object.is_object())
        throw FrameError(file +
                         ": expected a JSON object such as {\"preset\": \"bop\", \"depth_scale\": 0.1}");
    Convention convention;
    if (const auto named = object.find("preset"); named != object.end()) {
        const ConventionPreset* preset = named->is_string() ? preset_named(*named) : nullptr;
        if (preset == nullptr)
            refuse_key(file, "preset",
                       "expected one of " + joined(convention_names()) + ", found " + found_text(*named));
        convention = convention_of(*preset);
        object.erase(named);
    }
    for (const auto& [key, value] : object.items()) store(convention, key, value, file);
    return convention;
}

void store_channels(Convention& to, const std::string& word) {
    const std::string place = "channels '" + word + "'";
    for (const std::string& part : split(word, ',')) {
        const auto [key, name] = assignment(part, place);
        if (key != "id" && key != "depth") refuse_key(place, key, "expected id=NAME or depth=NAME");
        store(to, key + "_channel", name, place);
    }
}

}  // namespace

bool is_convention_file(const std::string& word) { return word.ends_with(".json"); }

Convention convention_from_words(const std::string& convention, const std::string& channels) {
    const std::string place = "convention '" + convention + "'";
    Convention stated;
    if (is_convention_file(convention))
        stated = from_file(convention);
    else if (!convention.empty())
        stated = from_word(convention, place);
    store_channels(stated, channels);
    check(stated, is_convention_file(convention) ? convention : place);
    return stated;
}

std::vector<std::string> convention_names() {
    std::vector<std::string> names;
    for (const ConventionPreset& preset : convention_presets()) names.emplace_back(preset.name);
    return names;
}

}  // namespace zproof
