#include "cli/viewer_evidence.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "cli/arguments.h"
#include "compare/illustration.h"
#include "frame/exr.h"
#include "reports/planes/view_planes.h"

namespace zproof {
namespace {

constexpr std::size_t most_stories_of_failed = 120, most_stories_of_proven = 24, most_images = 48;
constexpr double drawn_around_px = 1;

std::vector<planes::TriangleRange> ranges_of(const Scene& scene) {
    std::vector<planes::TriangleRange> ranges;
    for (const Part& p : scene.parts)
        ranges.push_back({p.first_triangle, p.triangle_count, p.node, p.mesh, p.primitive});
    return ranges;
}

std::vector<planes::Story> stories_of(const JudgedView& judged) {
    const auto& [scene, view] = std::tie(judged.docket.scene, judged.docket.view);
    const std::vector<PixelPlace> places = telling_pixels(
        judged.verdict, defect_count(judged.verdict) > 0 ? most_stories_of_failed : most_stories_of_proven);
    std::vector<PixelStory> told = explain(scene, view, judged.candidate, judged.reference, places);
    auto images = images_around(scene, view, places, drawn_around_px, most_images);
    std::vector<planes::Story> stories;
    for (std::size_t i = 0; i < told.size(); ++i) {
        std::string text = in_words(scene, told[i]);
        stories.push_back({std::move(told[i]), std::move(text), std::move(images[i])});
    }
    return stories;
}

planes::ViewFacts facts_of(const Docket& docket) {
    const Camera& camera = docket.view.camera;
    const bool perspective = camera.projection == Projection::perspective;
    const auto nearness = [&](double depth) { return perspective ? 1 / depth : -depth; };
    const std::string command = explain_command_for(docket, docket.parties.candidate, 0, 0);
    const std::string scene = "zproof explain " + shell_quoted(word_for(docket.source));
    return {.scene = docket.scene.name,
            .view = docket.view.name,
            .explain_before = scene + " ",
            .explain_after = command.substr(scene.size() + std::string(" 0 0").size()),
            .least_nearness = nearness(camera.far_depth),
            .greatest_nearness = nearness(camera.near_depth),
            .perspective = perspective};
}

Picture colours_in(const std::filesystem::path& file) {
    return std::filesystem::exists(file) ? read_picture_exr(file) : Picture{};
}

}  // namespace

std::vector<PixelPlace> telling_pixels(const Verdict& verdict, std::size_t most) {
    std::vector<const Finding*> worst_first;
    for (const Finding& finding : verdict.findings) worst_first.push_back(&finding);
    const auto severity = [](const Finding* f) {
        return std::pair{f->verdict, std::isnan(f->error_over_bound) ? -1 : f->error_over_bound};
    };
    std::ranges::stable_sort(worst_first, std::greater<>{}, severity);
    std::set<std::tuple<PixelClass, PrimitiveId, PrimitiveId>> seen;
    std::vector<const Finding*> told, rest;
    for (const Finding* f : worst_first) {
        const auto [low, high] = std::minmax(f->candidate.primitive, f->reference.primitive);
        (seen.insert({f->verdict, low, high}).second ? told : rest).push_back(f);
    }
    told.insert(told.end(), rest.begin(), rest.end());
    if (told.size() > most) told.resize(most);
    std::ranges::sort(told, {}, [](const Finding* f) { return std::pair{f->y, f->x}; });
    std::vector<PixelPlace> places;
    for (const Finding* finding : told) places.push_back({finding->x, finding->y});
    return places;
}

void write_viewer_evidence(const std::filesystem::path& folder, JudgedView judged) {
    auto& [docket, candidate, reference, verdict, errors, statements] = judged;
    planes::ViewPlanes shown{
        .facts = facts_of(docket),
        .candidate = {name_of(docket.parties.candidate), candidate.frame, colours_in(folder / "colour.exr")},
        .reference = {name_of(docket.parties.reference), reference.frame, {}},
        .witnesses = {},
        .verdict = verdict,
        .candidate_error = std::move(errors.candidate),
        .reference_error = std::move(errors.reference),
        .ranges = ranges_of(docket.scene),
        .stories = stories_of(judged)};
    for (const Statement& statement : statements)
        if (statement.frame)
            shown.witnesses.push_back({statement.result.name, *statement.frame,
                                       colours_in(folder / (statement.result.name + "-colour.exr"))});
    planes::write_view_planes(folder, shown);
}

}  // namespace zproof
