#include "frame/precision_text.h"

#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "frame/did_you_mean.h"
#include "frame/found_text.h"
#include "frame/frame_error.h"
#include "frame/input_file.h"
#include "frame/json_keys.h"
#include "frame/joined.h"
#include "frame/number_text.h"
#include "frame/precision_fields.h"
#include "frame/precision_presets.h"
#include "frame/precision_words.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

/// A JSON object whose keys are taken out one by one; what is left over at the end is refused.
class Declaration {
  public:
    Declaration(Json object, std::string place) : object_(std::move(object)), place_(std::move(place)) {
        if (!object_.is_object()) refuse("", "expected an object such as {\"kind\": \"raster\"}");
    }

    /// One of the words of an enumeration.
    template <class T>
    requires std::is_enum_v<T>
    void peek(const std::string& key, T& value) const {
        const Json found = at(key);
        if (found.is_null()) return;
        std::string words;
        for (int i = 0; !word_of(T(i)).empty(); ++i) {
            if (found == word_of(T(i))) return void(value = T(i));
            words += (i == 0 ? "\"" : " or \"") + std::string(word_of(T(i))) + "\"";
        }
        refuse(key, "expected " + words + ", found " + found_text(found));
    }

    void peek(const std::string& key, int& value, const Limits& limits) const {
        const Json found = at(key);
        if (found.is_null()) return;
        if (!found.is_number_integer() || found < limits.low || found > limits.high)
            refuse(key, "expected a whole number from " + with_digits(limits.low, 6) + " to " +
                            with_digits(limits.high, 6) + ", found " + found_text(found));
        value = found.get<int>();
    }

    void peek(const std::string& key, double& value, const Limits& limits) const {
        const Json found = at(key);
        if (found.is_null()) return;
        if (!found.is_number() || found < limits.low || found > limits.high)
            refuse(key, "expected a number from " + with_digits(limits.low, 6) + " to " +
                            with_digits(limits.high, 6) + ", found " + found_text(found));
        value = found.get<double>();
    }

    void peek(const std::string& key, bool& value) const {
        const Json found = at(key);
        if (found.is_null()) return;
        if (!found.is_boolean()) refuse(key, "expected true or false, found " + found_text(found));
        value = found.get<bool>();
    }

    bool holds(const std::string& key) const { return object_.contains(key); }

    /// The key's value, or null where it is left out.
    Json at(const std::string& key) const {
        const auto place = object_.find(key);
        if (place == object_.end()) return nullptr;
        if (place->is_null()) refuse(key, "null says nothing; leave the key out for its default");
        return *place;
    }
    Json take(const std::string& key) {
        Json value = at(key);
        object_.erase(key);
        return value;
    }

    void refuse_what_is_left(const std::vector<std::string>& allowed) const {
        if (object_.empty()) return;
        const std::string& key = object_.begin().key();
        refuse(key, "unknown key" + did_you_mean_or_all(key, allowed));
    }

    [[noreturn]] void refuse(const std::string& key, const std::string& why) const {
        throw FrameError(place_ + (key.empty() ? "" : ": /" + key) + ": " + why);
    }

  private:
    Json object_;
    std::string place_;
};

/// What other keys mean for one that is left out.
void set_defaults(RasterPrecision& p, const Declaration& declaration) {
    if (p.depth_buffer != DepthBuffer::camera_depth && !declaration.holds("depth_interpolation"))
        p.depth_interpolation = DepthInterpolation::plane;
    if (p.depth_buffer == DepthBuffer::standard_z && !declaration.holds("matrix_far"))
        p.matrix_far = MatrixFar::finite;
}
void set_defaults(RayPrecision& p, const Declaration& declaration) {
    if (p.test == RayTest::moeller_trumbore && !declaration.holds("watertight")) p.watertight = false;
}
void set_defaults(PlaneRayPrecision&, const Declaration&) {}
void set_defaults(BoundedPrecision&, const Declaration& declaration) {
    if (!declaration.holds("eps_px")) declaration.refuse("eps_px", "missing; expected a number of pixels");
}

template <class P>
P precision_of(Declaration& declaration) {
    P p;
    const auto set = [&](const char* key, auto& value, const auto&... limits) {
        declaration.peek(key, value, limits...);
    };
    visit_fields(p, set);
    set_defaults(p, declaration);
    std::vector<std::string> allowed{"kind", "projections"};
    visit_fields(p, [&](const char* key, auto&, const auto&...) {
        declaration.take(key);
        allowed.emplace_back(key);
    });
    declaration.take("projections");
    declaration.refuse_what_is_left(allowed);
    return p;
}

template <class P>
Json object_of(P p) {
    Json object{{"kind", kind_of(p)}};
    visit_fields(p, [&](const char* key, const auto& value, const auto&...) {
        if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>)
            object[key] = word_of(value);
        else
            object[key] = value;
    });
    return object;
}

/// A declaration of a preset begins with what the preset declares.
Json with_preset(Json object) {
    const auto kind = object.is_object() ? object.find("kind") : object.end();
    if (!object.is_object() || kind == object.end() || !kind->is_string()) return object;
    const std::optional<Precision> preset = preset_precision(kind->get<std::string>());
    if (!preset) return object;
    Json all = Json::parse(precision_to_json(*preset));
    for (const auto& [key, value] : object.items())
        if (key != "kind") all[key] = value;
    return all;
}

std::string kinds_in_words() {
    return R"(expected "raster", "ray", "plane_ray", "bounded" or a preset: )" +
           joined(precision_presets(), ", ", &PrecisionPreset::name);
}

/// The kind that a word which is none was meant to be, as the end of a sentence.
std::string meant_kind(const std::string& word) {
    std::vector<std::string> kinds{"raster", "ray", "plane_ray", "bounded"};
    for (const PrecisionPreset& preset : precision_presets()) kinds.emplace_back(preset.name);
    return did_you_mean(word.substr(0, word.find(',')), kinds);
}

bool is_kind(const std::string& word) {
    return word == "raster" || word == "ray" || word == "plane_ray" || word == "bounded" ||
           preset_precision(word).has_value();
}

Precision declared(Json object, const std::string& place) {
    Declaration declaration(with_preset(std::move(object)), place);
    const Json kind = declaration.take("kind");
    if (kind == "raster") return precision_of<RasterPrecision>(declaration);
    if (kind == "ray") return precision_of<RayPrecision>(declaration);
    if (kind == "plane_ray") return precision_of<PlaneRayPrecision>(declaration);
    if (kind == "bounded") return precision_of<BoundedPrecision>(declaration);
    declaration.refuse("kind", kinds_in_words());
}

Projections projections_of(const Json& list, const Declaration& declaration) {
    Projections found{false, false, false};
    const std::string expected =
        R"(expected a list of "perspective", "orthographic" and "oblique", found )" + found_text(list);
    if (!list.is_array() || list.empty()) declaration.refuse("projections", expected);
    for (const Json& word : list) {
        if (word == "perspective")
            found.perspective = true;
        else if (word == "orthographic")
            found.orthographic = true;
        else if (word == "oblique")
            found.oblique = true;
        else
            declaration.refuse("projections", expected);
    }
    return found;
}

/// "raster,subpixel_bits=4" as the object that it stands for.
Json object_from_word(const std::string& word) {
    Json object;
    std::istringstream parts(word);
    std::string part;
    std::getline(parts, part, ',');
    object["kind"] = part;
    while (std::getline(parts, part, ',')) {
        const std::size_t sign = part.find('=');
        if (sign == std::string::npos)
            throw FrameError("precision '" + word + "': expected KEY=VALUE, found '" + part + "'");
        const std::string value = part.substr(sign + 1);
        const Json number = Json::parse(value, nullptr, false);
        object[part.substr(0, sign)] = number.is_number() || number.is_boolean() ? number : Json(value);
    }
    return object;
}

/// What --precision was given, as an object that nothing is known of.
struct Undeclared {
    Json object;
    std::string place;
};

Undeclared parsed(const std::string& text, const std::string& place) {
    constexpr std::size_t longest = 1 << 16;
    if (text.size() > longest) throw FrameError(place + ": more than 64 KiB; a declaration is a few keys");
    refuse_repeated_key(text, place);
    Json object = Json::parse(text, nullptr, false);
    if (object.is_discarded())
        throw FrameError(place + ": not JSON; expected an object such as {\"kind\": \"raster\"}");
    return {std::move(object), place};
}

Undeclared object_of_word(const std::string& word) {
    if (is_promise_in_words(word)) return {object_from_word(word), "precision '" + word + "'"};
    return parsed(
        read_input(
            word, {.words = "a JSON file, a preset such as opengl, or a word such as raster,subpixel_bits=8" +
                            meant_kind(word)}),
        word);
}

}  // namespace

bool is_promise_in_words(const std::string& word) { return is_kind(word.substr(0, word.find(','))); }

Precision precision_from_json(const std::string& text, const std::string& place) {
    return declared(parsed(text, place).object, place);
}

Precision precision_from_word(const std::string& word) {
    auto [object, place] = object_of_word(word);
    return declared(std::move(object), place);
}

Projections projections_from_word(const std::string& word) {
    auto [object, place] = object_of_word(word);
    const Declaration declaration(with_preset(std::move(object)), place);
    const Json list = declaration.at("projections");
    return list.is_null() ? Projections{} : projections_of(list, declaration);
}

std::string precision_to_json(const Precision& precision) {
    return std::visit([](const auto& p) { return object_of(p).dump(); }, precision);
}

}  // namespace zproof
