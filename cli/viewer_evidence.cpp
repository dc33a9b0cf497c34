#include "cli/viewer_evidence.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "cli/arguments.h"
#include "compare/explanation/illustration.h"
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
    const Scene& scene = judged.docket.scene;
    const View& view = judged.docket.view;
    const std::vector<PixelPlace> places = telling_pixels(
        judged.verdict, defect_count(judged.verdict) > 0 ? most_stories_of_failed : most_stories_of_proven);
    std::vector<IllustratedStory> told =
        illustrate(scene, view, judged.candidate, judged.reference, {places, drawn_around_px, most_images});
    std::vector<planes::Story> stories(told.size());
    tbb::parallel_for(std::size_t(0), told.size(), [&](std::size_t i) {
        auto& [story, images] = told[i];
        std::string text = in_words(scene, story);
        stories[i] = {std::move(story), std::move(text), std::move(images)};
    });
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

/// Severest class first, then the largest error over its bound, then in raster order.
bool is_worse(const Finding* a, const Finding* b) {
    const auto error = [](const Finding* f) {
        return std::isnan(f->error_over_bound) ? -1 : f->error_over_bound;
    };
    if (a->verdict != b->verdict) return a->verdict > b->verdict;
    if (error(a) != error(b)) return error(a) > error(b);
    return a < b;
}

/// Of every class and pair of triangles, whichever says which, the worst finding; the worst of them first.
std::vector<const Finding*> worst_of_each_pair(std::span<const Finding> findings) {
    const auto hashed = [](const Finding* f) {
        const auto [low, high] = std::minmax(f->candidate.primitive, f->reference.primitive);
        const std::uint64_t pair = std::uint64_t(low) << 32 | std::uint64_t(high);
        return std::size_t((pair ^ std::uint64_t(f->verdict) << 28) * 0x9E37'79B9'7F4A'7C15u >> 16);
    };
    const auto alike = [](const Finding* a, const Finding* b) {
        return a->verdict == b->verdict && std::minmax(a->candidate.primitive, a->reference.primitive) ==
                                               std::minmax(b->candidate.primitive, b->reference.primitive);
    };
    std::unordered_map<const Finding*, const Finding*, decltype(hashed), decltype(alike)> worst(16, hashed,
                                                                                                alike);
    for (const Finding& f : findings) {
        const auto [found, is_new] = worst.try_emplace(&f, &f);
        if (!is_new && is_worse(&f, found->second)) found->second = &f;
    }
    std::vector<const Finding*> sorted;
    for (const auto& [any, one] : worst) sorted.push_back(one);
    std::ranges::sort(sorted, is_worse);
    return sorted;
}

/// The worst of those that are not among `told`.
std::vector<const Finding*> worst_but(const std::vector<const Finding*>& told,
                                      std::span<const Finding> findings, std::size_t most) {
    const std::set<const Finding*> seen(told.begin(), told.end());
    std::vector<const Finding*> rest;
    for (const Finding& f : findings)
        if (!seen.contains(&f)) rest.push_back(&f);
    const std::size_t count = std::min(most, rest.size());
    std::ranges::partial_sort(rest, rest.begin() + std::ptrdiff_t(count), is_worse);
    rest.resize(count);
    return rest;
}

Picture colours_in(const std::filesystem::path& file) {
    return std::filesystem::exists(file) ? read_picture_exr(file) : Picture{};
}

}  // namespace

std::vector<PixelPlace> telling_pixels(const Verdict& verdict, std::size_t most) {
    std::vector<const Finding*> told = worst_of_each_pair(verdict.findings);
    if (told.size() < most) {
        const std::vector<const Finding*> rest = worst_but(told, verdict.findings, most - told.size());
        told.insert(told.end(), rest.begin(), rest.end());
    }
    told.resize(std::min(told.size(), most));
    std::ranges::sort(told, {}, [](const Finding* f) { return std::pair{f->y, f->x}; });
    std::vector<PixelPlace> places;
    for (const Finding* finding : told) places.push_back({finding->x, finding->y});
    return places;
}

void write_viewer_evidence(const std::filesystem::path& folder, const JudgedView& judged) {
    const auto& [docket, candidate, reference, verdict, statements] = judged;
    planes::ViewPlanes shown{
        .facts = facts_of(docket),
        .candidate = {name_of(docket.parties.candidate), candidate.frame, colours_in(folder / "colour.exr")},
        .reference = {name_of(docket.parties.reference), reference.frame, {}},
        .witnesses = {},
        .verdict = verdict,
        .candidate_error = std::move(verdict.errors->candidate),
        .reference_error = std::move(verdict.errors->reference),
        .ranges = ranges_of(docket.scene),
        .stories = stories_of(judged)};
    for (const Statement& statement : statements)
        if (statement.frame)
            shown.witnesses.push_back({statement.result.name, *statement.frame,
                                       colours_in(folder / (statement.result.name + "-colour.exr"))});
    planes::write_view_planes(folder, shown);
}

}  // namespace zproof
