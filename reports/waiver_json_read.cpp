#include "reports/report_error.h"
#include "reports/waiver_json.h"
#include "reports/whole_number.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

PrimitiveId id_from(const Json& json) {
    return json.is_null() ? PrimitiveId::none : PrimitiveId(whole_number<std::uint32_t>(json));
}

decltype(Waiver::where) place_from(const Json& json) {
    const std::string kind = json.at("kind");
    if (kind == "triangles") {
        AtTriangles at;
        for (const Json& one : json.at("triangles")) at.triangles.push_back(id_from(one));
        return at;
    }
    if (kind == "pairs") {
        AtPairs at;
        for (const Json& one : json.at("pairs"))
            at.pairs.emplace_back(id_from(one.at(0)), id_from(one.at(1)));
        return at;
    }
    if (kind != "pixels") return Anywhere{};
    const auto side = [](const Json& list, std::size_t i) { return whole_number<int>(list.at(i)); };
    AtPixels at{.size = {side(json.at("size"), 0), side(json.at("size"), 1)}, .rectangles = {}};
    for (const Json& r : json.at("rectangles"))
        at.rectangles.push_back({side(r, 0), side(r, 1), side(r, 2), side(r, 3)});
    return at;
}

PixelClass class_from(const std::string& name) {
    for (int i = 0; i < pixel_class_count; ++i)
        if (name_of(PixelClass(i)) == name) return PixelClass(i);
    throw ReportError("results.json: no pixel class is named \"" + name + "\"");
}

Day day(const Json& json) {
    const std::string text = json;
    if (const auto found = day_from(text)) return *found;
    throw ReportError("results.json: expected a day such as 2026-04-10, found \"" + text + "\"");
}

WaiverEffect effect_from(const std::string& name) {
    for (const WaiverEffect effect :
         {WaiverEffect::holds, WaiverEffect::fewer, WaiverEffect::none, WaiverEffect::exceeded,
          WaiverEffect::expired, WaiverEffect::other_scene})
        if (name_of(effect) == name) return effect;
    throw ReportError("results.json: no effect of a waiver is named \"" + name + "\"");
}

}  // namespace

Waiver waiver_from(const Json& json) {
    Waiver w{.id = json.at("id"),
             .scene = json.at("scene"),
             .view = json.at("view"),
             .classes = {},
             .where = place_from(json.at("where")),
             .least = whole_number<std::uint64_t>(json.at("count").at("min")),
             .most = whole_number<std::uint64_t>(json.at("count").at("max")),
             .reason = json.at("reason"),
             .link = json.at("link"),
             .created = day(json.at("created")),
             .expires = day(json.at("expires")),
             .scene_sha256 = json.at("scene_sha256"),
             .origin = json.at("origin")};
    for (const Json& name : json.at("classes")) w.classes.push_back(class_from(name));
    return w;
}

WaiverUse waiver_use_from(const Json& json) {
    return {.id = json.at("id"),
            .effect = effect_from(json.at("effect")),
            .matched = whole_number<std::uint64_t>(json.at("matched")),
            .waived = whole_number<std::uint64_t>(json.at("waived"))};
}

}  // namespace zproof
