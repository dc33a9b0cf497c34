#include "compare/waivers/coverage.h"

#include <algorithm>

namespace zproof {
namespace {

bool holds(const Anywhere&, const Finding&) { return true; }

bool holds(const AtTriangles& place, const Finding& f) {
    const auto is_named = [&](PrimitiveId id) {
        return id != PrimitiveId::none && std::ranges::count(place.triangles, id) > 0;
    };
    return is_named(f.candidate.primitive) || is_named(f.reference.primitive);
}

bool holds(const AtPairs& place, const Finding& f) {
    return std::ranges::count(place.pairs, std::pair{f.candidate.primitive, f.reference.primitive}) > 0;
}

bool holds(const AtPixels& place, const Finding& f) {
    return std::ranges::any_of(place.rectangles, [&](const PixelRectangle& r) {
        return f.x >= r.x && f.x - r.x < r.width && f.y >= r.y && f.y - r.y < r.height;
    });
}

/// Is this the scene, and the size of image, that it was written for?
bool knows(const Waiver& waiver, const WaivedView& view) {
    const auto* pixels = std::get_if<AtPixels>(&waiver.where);
    if (pixels != nullptr && pixels->size != view.size) return false;
    return waiver.scene_sha256.empty() || waiver.scene_sha256 == view.scene_sha256;
}

WaiverEffect effect_of(const Waiver& waiver, const WaivedView& view, std::uint64_t matched, Day today) {
    if (is_expired(waiver, today)) return WaiverEffect::expired;
    if (!knows(waiver, view)) return WaiverEffect::other_scene;
    if (matched > waiver.most) return WaiverEffect::exceeded;
    if (matched == 0) return WaiverEffect::none;
    return matched < waiver.least ? WaiverEffect::fewer : WaiverEffect::holds;
}

bool waives(WaiverEffect effect) { return effect == WaiverEffect::holds || effect == WaiverEffect::fewer; }

/// Puts one waiver to the findings.
void apply(const Waiver& waiver, std::size_t index, std::span<const Finding> findings,
           WaiverCoverage& coverage) {
    WaiverUse& use = coverage.uses.back();
    if (!waives(use.effect)) return;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        if (coverage.by[i] || !applies_to(waiver, findings[i])) continue;
        coverage.by[i] = index;
        ++use.waived;
    }
}

}  // namespace

std::string_view name_of(WaiverEffect effect) {
    switch (effect) {
        case WaiverEffect::holds:
            return "holds";
        case WaiverEffect::fewer:
            return "fewer";
        case WaiverEffect::none:
            return "none";
        case WaiverEffect::exceeded:
            return "exceeded";
        case WaiverEffect::expired:
            return "expired";
        case WaiverEffect::other_scene:
            return "other_scene";
    }
    return "none";
}

bool applies_to(const Waiver& waiver, const Finding& finding) {
    return is_waivable(finding.verdict) && std::ranges::count(waiver.classes, finding.verdict) > 0 &&
           std::visit([&](const auto& place) { return holds(place, finding); }, waiver.where);
}

WaiverCoverage cover(std::span<const Waiver> waivers, const WaivedView& view,
                     std::span<const Finding> findings, Day today) {
    WaiverCoverage coverage{.by = std::vector<std::optional<std::size_t>>(findings.size()), .uses = {}};
    for (std::size_t i = 0; i < waivers.size(); ++i) {
        const Waiver& waiver = waivers[i];
        if (!fits(waiver.scene, view.scene) || !fits(waiver.view, view.view)) continue;
        const auto matched = std::uint64_t(
            std::ranges::count_if(findings, [&](const Finding& f) { return applies_to(waiver, f); }));
        coverage.uses.push_back({waiver.id, effect_of(waiver, view, matched, today), matched, 0});
        apply(waiver, i, findings, coverage);
    }
    return coverage;
}

bool fits(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, retry = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;  // take nothing at first, one character more at each retry
            retry = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
            ++p, ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++retry;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace zproof
