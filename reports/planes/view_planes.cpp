#include "reports/planes/view_planes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <functional>

#include "reports/pictures.h"
#include "reports/planes/blocks.h"
#include "reports/planes/coding.h"
#include "reports/planes/deflate.h"
#include "reports/planes/error_code.h"
#include "reports/planes/stories.h"

namespace zproof::planes {

namespace {

Block class_block(const Plane<PixelClass>& classes) {
    static_assert(sizeof(PixelClass) == 1);
    return runs_block("class",
                      {reinterpret_cast<const char*>(classes.pixels().data()), classes.pixels().size()});
}

Block error_block(const std::string& name, const Plane<float>& errors) {
    return bytes_block(name, error_codes(errors.pixels()));
}

/// The three channels one after another, each number less its left neighbour, modulo 256.
Block colour_block(const std::string& name, const Picture& colours) {
    const Plane<Rgb8> light = picture_of_light(colours);
    const auto pixels = light.pixels();
    std::string plain, missed;
    for (const std::uint8_t Rgb8::*channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
        std::uint8_t left = 0;
        for (const Rgb8& pixel : pixels) {
            const std::uint8_t value = pixel.*channel;
            plain += char(value);
            missed += char(value - left);
            left = value;
        }
    }
    return {name, plane_facts("channels", plain), deflated_side_by_side(missed)};
}

std::vector<const Finding*> listed_findings(const Verdict& verdict, std::size_t most) {
    std::vector<const Finding*> listed;
    for (const Finding& finding : verdict.findings) listed.push_back(&finding);
    std::stable_partition(listed.begin(), listed.end(),
                          [](const Finding* f) { return is_defect(f->verdict); });
    if (listed.size() > most) listed.resize(most);
    std::ranges::sort(listed, {}, [](const Finding* f) { return std::pair{f->y, f->x}; });
    return listed;
}

std::uint32_t word(float value) { return std::bit_cast<std::uint32_t>(value); }

/// A table: its columns of words one after another, as one plane with a row per column, then those of
/// doubles.
Block findings_block(const Verdict& verdict, int width, std::size_t most) {
    const std::vector<const Finding*> listed = listed_findings(verdict, most);
    std::vector<std::uint32_t> words;
    std::vector<double> doubles;
    const auto add = [&](auto& column, const auto& value_of) {
        for (const Finding* f : listed) column.push_back(value_of(*f));
    };
    add(words,
        [&](const Finding& f) { return std::uint32_t(f.y) * std::uint32_t(width) + std::uint32_t(f.x); });
    add(words, [](const Finding& f) { return std::uint32_t(f.candidate.primitive); });
    add(words, [](const Finding& f) { return std::uint32_t(f.reference.primitive); });
    add(words, [](const Finding& f) { return word(f.candidate.camera_depth); });
    add(words, [](const Finding& f) { return word(f.reference.camera_depth); });
    add(doubles, [](const Finding& f) { return f.eps_px; });
    add(doubles, [](const Finding& f) { return f.candidate_depth.low; });
    add(doubles, [](const Finding& f) { return f.candidate_depth.truth; });
    add(doubles, [](const Finding& f) { return f.candidate_depth.high; });
    add(doubles, [](const Finding& f) { return f.error_over_bound; });
    const std::string first = encode(words, std::max<std::size_t>(listed.size(), 1), Prediction::left);
    return {"findings",
            {{"coding", "table"},
             {"count", listed.size()},
             {"words", first.size()},
             {"all", verdict.findings.size()}},
            first + encode(doubles)};
}

/// A block that is yet to be made: they are made side by side.
using Recipe = std::function<Block()>;

/// A renderer's ids or depths. Beside the candidate's they are nearly nothing.
void add_ids(std::vector<Recipe>& recipes, const std::string& name, const Renderer& other,
             const Renderer& candidate) {
    const Words values = other.frame.primitive.pixels(), guess = candidate.frame.primitive.pixels();
    recipes.push_back([=] { return beside(name + ".id", values, {"candidate.id", guess}); });
}

void add_depths(std::vector<Recipe>& recipes, const std::string& name, const Renderer& other,
                const Renderer& candidate) {
    const Words values = other.frame.camera_depth.pixels(), guess = candidate.frame.camera_depth.pixels();
    recipes.push_back([=] { return beside(name + ".depth", values, {"candidate.depth", guess}); });
}

void add_colours(std::vector<Recipe>& recipes, const std::string& name, const Picture& colours) {
    if (colours.size().pixel_count() > 0)
        recipes.push_back([&colours, name] { return colour_block(name + ".colour", colours); });
}

nlohmann::json header_of(const ViewPlanes& v) {
    const Resolution size = v.candidate.frame.size();
    nlohmann::json oracles = nlohmann::json::array();
    for (const Renderer& w : v.oracles) oracles.push_back(w.name);
    return {{"width", size.width},
            {"height", size.height},
            {"scene", v.facts.scene},
            {"view", v.facts.view},
            {"candidate", v.candidate.name},
            {"reference", v.reference.name},
            {"oracles", std::move(oracles)},
            {"explain", {v.facts.explain_before, v.facts.explain_after}},
            {"inverse_depth", {v.facts.least_inverse_depth, v.facts.greatest_inverse_depth}},
            {"perspective", v.facts.perspective}};
}

std::vector<Block> made(const std::vector<Recipe>& recipes) {
    std::vector<Block> blocks(recipes.size());
    tbb::parallel_for(std::size_t(0), recipes.size(), [&](std::size_t i) { blocks[i] = recipes[i](); });
    return blocks;
}

}  // namespace

Container container_of(const ViewPlanes& v, PlanesDetail detail) {
    const auto width = std::size_t(v.candidate.frame.size().width);
    const Frame& ours = v.candidate.frame;
    const std::size_t most = detail == PlanesDetail::all ? most_findings : most_in_summary;
    std::vector<Recipe> recipes{[&] { return class_block(v.verdict.classes); },
                                [&] { return findings_block(v.verdict, int(width), most); },
                                [&] { return json_block("stories", to_json(v.stories)); },
                                [&] { return json_block("ranges", to_json(v.ranges)); }};
    if (detail == PlanesDetail::differences) return {header_of(v), made(recipes)};
    recipes.push_back(
        [&] { return predicted("candidate.id", ours.primitive.pixels(), width, Prediction::left); });
    add_ids(recipes, "reference", v.reference, v.candidate);
    recipes.push_back([&] { return error_block("candidate.error", v.candidate_error); });
    recipes.push_back([&] { return error_block("reference.error", v.reference_error); });
    recipes.push_back(
        [&] { return predicted("candidate.depth", ours.camera_depth.pixels(), width, Prediction::planar); });
    add_depths(recipes, "reference", v.reference, v.candidate);
    for (const Renderer& w : v.oracles) add_ids(recipes, "oracle." + w.name, w, v.candidate);
    for (const Renderer& w : v.oracles) add_depths(recipes, "oracle." + w.name, w, v.candidate);
    add_colours(recipes, "candidate", v.candidate.colours);
    for (const Renderer& w : v.oracles) add_colours(recipes, "oracle." + w.name, w.colours);
    return {header_of(v), made(recipes)};
}

void write_view_planes(const std::filesystem::path& folder, const ViewPlanes& planes, PlanesDetail detail) {
    write(folder / "planes.zvp", container_of(planes, detail));
}

}  // namespace zproof::planes
