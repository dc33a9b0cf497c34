#include "reports/waiver_json.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

Json id(PrimitiveId primitive) {
    return primitive == PrimitiveId::none ? Json(nullptr) : Json(static_cast<std::uint32_t>(primitive));
}

Json place(const Anywhere&) { return {{"kind", "anywhere"}}; }

Json place(const AtTriangles& at) {
    Json ids = Json::array();
    for (const PrimitiveId triangle : at.triangles) ids.push_back(id(triangle));
    return {{"kind", "triangles"}, {"triangles", ids}};
}

Json place(const AtPairs& at) {
    Json pairs = Json::array();
    for (const auto& [candidate, reference] : at.pairs)
        pairs.push_back(Json::array({id(candidate), id(reference)}));
    return {{"kind", "pairs"}, {"pairs", pairs}};
}

Json place(const AtPixels& at) {
    Json rectangles = Json::array();
    for (const PixelRectangle& r : at.rectangles)
        rectangles.push_back(Json::array({r.x, r.y, r.width, r.height}));
    return {{"kind", "pixels"}, {"size", {at.size.width, at.size.height}}, {"rectangles", rectangles}};
}

}  // namespace

Json waiver_object(const Waiver& w) {
    Json classes = Json::array();
    for (const PixelClass c : w.classes) classes.push_back(name_of(c));
    return {{"id", w.id},
            {"scene", w.scene},
            {"view", w.view},
            {"classes", classes},
            {"where", std::visit([](const auto& at) { return place(at); }, w.where)},
            {"count", {{"min", w.least}, {"max", w.most}}},
            {"reason", w.reason},
            {"link", w.link},
            {"created", in_words(w.created)},
            {"expires", in_words(w.expires)},
            {"scene_sha256", w.scene_sha256},
            {"origin", w.origin}};
}

Json waiver_use_object(const WaiverUse& use) {
    return {
        {"id", use.id}, {"effect", name_of(use.effect)}, {"matched", use.matched}, {"waived", use.waived}};
}

}  // namespace zproof
