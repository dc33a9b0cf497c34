#include "reports/planes/stories.h"

#include <cmath>
#include <string_view>

#include "reports/wording.h"

namespace zproof::planes {

namespace {

using nlohmann::json;

/// JSON has no NaN and no infinity.
json number(double value) { return std::isfinite(value) ? json(value) : json(shortest(value)); }

/// The shortest decimal that is this float.
json as_float(double value) { return json::parse(shortest(float(value)), nullptr, false); }

std::string_view word_for(Admissibility admissibility) {
    switch (admissibility) {
        case Admissibility::visible:
            return "visible";
        case Admissibility::clipped:
            return "visible, at a clip plane";
        case Admissibility::tied:
            return "tied in depth";
        case Admissibility::through_a_crack:
            return "through a crack";
        case Admissibility::undecidable:
            return "undecidable";
        case Admissibility::hole:
            return "covered";
        case Admissibility::outside:
            return "outside";
        case Admissibility::hidden:
            return "hidden";
    }
    return "";
}

json described(const Decision& decision) {
    return {{"word", word_for(decision.admissibility)},
            {"admissible", is_admissible(decision.admissibility)},
            {"exact", decision.exact}};
}

json described(const Candidate& candidate) {
    json edges = json::array();
    for (const double distance : candidate.edge_distance) edges.push_back(number(distance));
    return {
        {"id", std::uint32_t(candidate.primitive)},
        {"edges", std::move(edges)},
        {"depth", {number(candidate.depth.low), number(candidate.depth.truth), number(candidate.depth.high)}},
        {"admissibility", described(candidate.decision)}};
}

json described(const NearbyImage& image) {
    json edges = json::array();
    for (const Affine<double>& e : image.edge) edges.push_back({as_float(e.a), as_float(e.b), as_float(e.c)});
    const Affine<double>& n = image.inverse_depth;
    return {std::uint32_t(image.primitive), std::move(edges), {as_float(n.a), as_float(n.b), n.c}};
}

template <class T, class Describe>
json list(const std::vector<T>& items, const Describe& describe) {
    json array = json::array();
    for (const T& item : items) array.push_back(describe(item));
    return array;
}

json described(const Story& s) {
    const Finding& f = s.story.finding;
    json object{
        {"x", f.x},
        {"y", f.y},
        {"class", int(f.verdict)},
        {"text", s.text},
        {"eps", f.eps_px},
        {"reference_eps", s.story.reference.eps_px},
        {"depth",
         {number(f.candidate_depth.low), number(f.candidate_depth.truth), number(f.candidate_depth.high)}},
        {"error", number(f.error_over_bound)},
        {"background", described(s.story.background)},
        {"candidates", list(s.story.candidates, [](const Candidate& c) { return described(c); })},
        {"images", list(s.images, [](const NearbyImage& i) { return described(i); })}};
    if (s.story.ids_differ && f.verdict != PixelClass::invalid) {
        object["admissibility"] = described(s.story.candidate);
        object["reference_admissibility"] = described(s.story.reference);
    }
    return object;
}

}  // namespace

json to_json(const std::vector<Story>& stories) {
    return list(stories, [](const Story& story) { return described(story); });
}

json to_json(const std::vector<TriangleRange>& ranges) {
    json array = json::array();
    for (const TriangleRange& r : ranges) array.push_back({r.first, r.count, r.node, r.mesh, r.primitive});
    return array;
}

}  // namespace zproof::planes
