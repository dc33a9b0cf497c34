#include "cli/viewer_evidence.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "cli/arguments.h"
#include "compare/explanation/illustration.h"
#include "image_io/image_io.h"
#include "program/samples.h"
#include "program/shell_line.h"
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
    const Scene& scene = judged.context.scene;
    const View& view = judged.context.view;
    const std::vector<PixelCoord> places = telling_pixels(
        judged.verdict, defect_count(judged.verdict) > 0 ? most_stories_of_failed : most_stories_of_proven);
    std::vector<IllustratedExplanation> told =
        illustrate(scene, view, judged.candidate, judged.reference, {places, drawn_around_px, most_images});
    std::vector<planes::Story> stories(told.size());
    tbb::parallel_for(std::size_t(0), told.size(), [&](std::size_t i) {
        auto& [story, images] = told[i];
        std::string text = in_words(scene, story);
        stories[i] = {std::move(story), std::move(text), std::move(images)};
    });
    return stories;
}

planes::ViewFacts facts_of(const ViewContext& context) {
    const Camera& camera = context.view.camera;
    const bool perspective = camera.projection == Projection::perspective;
    const auto inverse_depth = [&](double depth) { return perspective ? 1 / depth : -depth; };
    const std::string command = explain_command_for(context, context.renderers.candidate, 0, 0);
    const std::string scene = "zproof explain " + shell_quoted(word_for(context.source));
    return {.scene = context.scene.name,
            .view = shown_name(context.view),
            .explain_before = scene + " ",
            .explain_after = command.substr(scene.size() + std::string(" 0 0").size()),
            .least_inverse_depth = inverse_depth(camera.far_depth),
            .greatest_inverse_depth = inverse_depth(camera.near_depth),
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

/// The worst finding of every class and pair of triangles, whichever frame names which; the worst comes
/// first.
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
    return std::filesystem::exists(file) ? read_picture(file) : Picture{};
}

}  // namespace

std::vector<PixelCoord> telling_pixels(const Verdict& verdict, std::size_t most) {
    std::vector<const Finding*> told = worst_of_each_pair(verdict.findings);
    if (told.size() < most) {
        const std::vector<const Finding*> rest = worst_but(told, verdict.findings, most - told.size());
        told.insert(told.end(), rest.begin(), rest.end());
    }
    told.resize(std::min(told.size(), most));
    std::ranges::sort(told, {}, [](const Finding* f) { return std::pair{f->y, f->x}; });
    std::vector<PixelCoord> places;
    for (const Finding* finding : told) places.push_back({finding->x, finding->y});
    return places;
}

void write_viewer_summary(const std::filesystem::path& folder, const JudgedView& judged) {
    const auto& [context, candidate, reference, verdict, answers] = judged;
    planes::write_view_planes(folder,
                              {.facts = facts_of(context),
                               .candidate = {name_of(context.renderers.candidate), candidate.frame, {}},
                               .reference = {name_of(context.renderers.reference), reference.frame, {}},
                               .oracles = {},
                               .verdict = verdict,
                               .candidate_error = {},
                               .reference_error = {},
                               .ranges = ranges_of(context.scene),
                               .stories = {}},
                              planes::PlanesDetail::differences);
}

void write_viewer_evidence(const std::filesystem::path& folder, const JudgedView& judged) {
    const auto& [context, candidate, reference, verdict, answers] = judged;
    planes::ViewPlanes shown{.facts = facts_of(context),
                             .candidate = {name_of(context.renderers.candidate), candidate.frame,
                                           colours_in(folder / "colour.exr")},
                             .reference = {name_of(context.renderers.reference), reference.frame, {}},
                             .oracles = {},
                             .verdict = verdict,
                             .candidate_error = std::move(verdict.errors->candidate),
                             .reference_error = std::move(verdict.errors->reference),
                             .ranges = ranges_of(context.scene),
                             .stories = stories_of(judged)};
    for (const OracleAnswer& answer : answers)
        if (answer.frame && !answer.pixels)
            shown.oracles.push_back({answer.result.name, *answer.frame,
                                     colours_in(folder / (answer.result.name + "-colour.exr"))});
    planes::write_view_planes(folder, shown);
}

}  // namespace zproof
