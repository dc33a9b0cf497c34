#include "frame/precision_text.h"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include "frame/frame_error.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

// The words of a declaration. Values run from 0; behind the last of a type there is no word.

constexpr std::string_view word_of(Arithmetic value) {
    switch (value) {
        case Arithmetic::float32:
            return "float32";
        case Arithmetic::float64:
            return "float64";
    }
    return {};
}

constexpr std::string_view word_of(Origin value) {
    switch (value) {
        case Origin::world:
            return "world";
        case Origin::eye:
            return "eye";
    }
    return {};
}

constexpr std::string_view word_of(Snap value) {
    switch (value) {
        case Snap::nearest:
            return "nearest";
        case Snap::truncate:
            return "truncate";
    }
    return {};
}

constexpr std::string_view word_of(Clipping value) {
    switch (value) {
        case Clipping::guard_band:
            return "guard_band";
        case Clipping::view_volume:
            return "view_volume";
    }
    return {};
}

constexpr std::string_view word_of(DepthBuffer value) {
    switch (value) {
        case DepthBuffer::camera_depth:
            return "camera_depth";
        case DepthBuffer::reversed_z:
            return "reversed_z";
    }
    return {};
}

/// A JSON object whose keys are taken out one by one; what is left over at the end is refused.
class Declaration {
  public:
    Declaration(Json object, std::string place) : object_(std::move(object)), place_(std::move(place)) {
        if (!object_.is_object()) refuse("", "expected an object such as {\"kind\": \"raster\"}");
    }

    /// One of the words of an enumeration.
    template <class T>
    requires std::is_enum_v<T>
    void take(const std::string& key, T& value) {
        const Json found = take(key);
        if (found.is_null()) return;
        std::string words;
        for (int i = 0; !word_of(T(i)).empty(); ++i) {
            if (found == word_of(T(i))) return void(value = T(i));
            words += (i == 0 ? "\"" : " or \"") + std::string(word_of(T(i))) + "\"";
        }
        refuse(key, "expected " + words + ", found " + found.dump());
    }

    void take(const std::string& key, int low, int high, int& value) {
        const Json found = take(key);
        if (found.is_null()) return;
        const bool fits = found.is_number_integer() && found >= low && found <= high;
        if (!fits)
            refuse(key, "expected a whole number from " + std::to_string(low) + " to " +
                            std::to_string(high) + ", found " + found.dump());
        value = found.get<int>();
    }

    /// A share or a distance: 0 to 1.
    void take(const std::string& key, double& value) {
        const Json found = take(key);
        if (found.is_null()) return;
        if (!found.is_number() || found < 0 || found > 1)
            refuse(key, "expected a number from 0 to 1, found " + found.dump());
        value = found.get<double>();
    }

    Json take(const std::string& key) {
        const auto place = object_.find(key);
        if (place == object_.end()) return nullptr;
        Json value = std::move(*place);
        if (value.is_null()) refuse(key, "null says nothing; leave the key out for its default");
        object_.erase(place);
        return value;
    }

    void refuse_what_is_left(const std::string& allowed) const {
        if (!object_.empty()) refuse(object_.begin().key(), "unknown key; allowed here: kind, " + allowed);
    }

    [[noreturn]] void refuse(const std::string& key, const std::string& why) const {
        throw FrameError(place_ + (key.empty() ? "" : ": /" + key) + ": " + why);
    }

  private:
    Json object_;
    std::string place_;
};

RasterPrecision raster(Declaration& declaration) {
    RasterPrecision p;
    declaration.take("transform", p.transform);
    declaration.take("origin", p.origin);
    declaration.take("subpixel_bits", 0, 16, p.subpixel_bits);
    declaration.take("snap", p.snap);
    declaration.take("clipping", p.clipping);
    declaration.take("depth_buffer", p.depth_buffer);
    declaration.take("interpolation", p.interpolation);
    declaration.take("depth_roundings", 0, 1000, p.depth_roundings);
    declaration.refuse_what_is_left(
        "transform, origin, subpixel_bits, snap, clipping, depth_buffer, interpolation, depth_roundings");
    return p;
}

RayPrecision ray(Declaration& declaration) {
    RayPrecision p;
    declaration.take("arithmetic", p.arithmetic);
    declaration.refuse_what_is_left("arithmetic");
    return p;
}

PlaneRayPrecision plane_ray(Declaration& declaration) {
    PlaneRayPrecision p;
    declaration.take("aim_offset_px", p.aim_offset_px);
    declaration.take("least_corner_sine", p.least_corner_sine);
    declaration.take("least_grazing_sine", p.least_grazing_sine);
    declaration.take("depth_relative", p.depth_relative);
    declaration.take("depth_of_range", p.depth_of_range);
    declaration.take("clip_relative", p.clip_relative);
    declaration.take("clip_of_reach", p.clip_of_reach);
    declaration.refuse_what_is_left(
        "aim_offset_px, least_corner_sine, least_grazing_sine, depth_relative, depth_of_range, "
        "clip_relative, clip_of_reach");
    return p;
}

Json object_of(const PlaneRayPrecision& p) {
    return {{"kind", "plane_ray"},
            {"aim_offset_px", p.aim_offset_px},
            {"least_corner_sine", p.least_corner_sine},
            {"least_grazing_sine", p.least_grazing_sine},
            {"depth_relative", p.depth_relative},
            {"depth_of_range", p.depth_of_range},
            {"clip_relative", p.clip_relative},
            {"clip_of_reach", p.clip_of_reach}};
}

Json object_of(const RasterPrecision& p) {
    return {{"kind", "raster"},
            {"transform", word_of(p.transform)},
            {"origin", word_of(p.origin)},
            {"subpixel_bits", p.subpixel_bits},
            {"snap", word_of(p.snap)},
            {"clipping", word_of(p.clipping)},
            {"depth_buffer", word_of(p.depth_buffer)},
            {"interpolation", word_of(p.interpolation)},
            {"depth_roundings", p.depth_roundings}};
}

Json object_of(const RayPrecision& p) { return {{"kind", "ray"}, {"arithmetic", word_of(p.arithmetic)}}; }

Precision declared(Json object, const std::string& place) {
    Declaration declaration(std::move(object), place);
    const Json kind = declaration.take("kind");
    if (kind == "raster") return raster(declaration);
    if (kind == "ray") return ray(declaration);
    if (kind == "plane_ray") return plane_ray(declaration);
    declaration.refuse("kind", "expected \"raster\", \"ray\" or \"plane_ray\"");
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
        object[part.substr(0, sign)] = number.is_number() ? number : Json(value);
    }
    return object;
}

}  // namespace

Precision precision_from_json(const std::string& text, const std::string& place) {
    constexpr std::size_t longest = 1 << 16;
    if (text.size() > longest) throw FrameError(place + ": more than 64 KiB; a declaration is a few keys");
    Json object = Json::parse(text, nullptr, false);
    if (object.is_discarded())
        throw FrameError(place + ": not JSON; expected an object such as {\"kind\": \"raster\"}");
    return declared(std::move(object), place);
}

Precision precision_from_word(const std::string& word) {
    const std::string kind = word.substr(0, word.find(','));
    if (kind == "raster" || kind == "ray" || kind == "plane_ray")
        return declared(object_from_word(word), "precision '" + word + "'");
    std::ifstream file(word, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file)
        throw FrameError(word +
                         ": cannot be read; expected a JSON file, or a word such as raster,subpixel_bits=8");
    return precision_from_json(text, word);
}

std::string precision_to_json(const Precision& precision) {
    return std::visit([](const auto& p) { return object_of(p).dump(); }, precision);
}

}  // namespace zproof
