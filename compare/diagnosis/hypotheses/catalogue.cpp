#include "compare/diagnosis/hypotheses/catalogue.h"

#include <algorithm>
#include <array>
#include <ranges>
#include <utility>

namespace zproof {

namespace {

bool is_blank(const Frame& frame) {
    return std::ranges::all_of(frame.primitive.pixels(),
                               [](PrimitiveId id) { return id == PrimitiveId::none; });
}

enum class Kind { signs, place, depth, ids, dropped, drawing, coverage, parts, precision };

struct Family {
    Kind kind;
    std::vector<Hypothesis> (*hypotheses)(const DiagnosisInput&);
    enum class Asked { always, of_triangles, of_labels } asked = Asked::always;

    bool is_asked(const DiagnosisInput& input) const {
        return asked == Asked::always || (asked == Asked::of_labels) == (input.said != nullptr);
    }
};

constexpr std::array all_families{Family{Kind::signs, hypotheses_of_signs},
                                  Family{Kind::place, hypotheses_of_place},
                                  Family{Kind::place, hypotheses_of_grid},
                                  Family{Kind::depth, hypotheses_of_depth},
                                  Family{Kind::depth, hypotheses_of_flipped_depth},
                                  Family{Kind::place, hypotheses_of_depth_elsewhere},
                                  Family{Kind::depth, hypotheses_of_resolved_depth},
                                  Family{Kind::depth, hypotheses_of_packed_depth},
                                  Family{Kind::ids, hypotheses_of_ids, Family::Asked::of_triangles},
                                  Family{Kind::ids, hypotheses_of_shared_ids, Family::Asked::of_triangles},
                                  Family{Kind::ids, hypotheses_of_labels, Family::Asked::of_labels},
                                  Family{Kind::ids, hypotheses_of_blended_ids},
                                  Family{Kind::dropped, hypotheses_of_dropped_triangles},
                                  Family{Kind::drawing, hypotheses_of_drawing},
                                  Family{Kind::coverage, hypotheses_of_coverage},
                                  Family{Kind::parts, hypotheses_of_parts},
                                  Family{Kind::place, hypotheses_of_window},
                                  Family{Kind::place, hypotheses_of_fitted_cameras},
                                  Family{Kind::precision, hypotheses_of_precision}};

/// What may be wrong where a frame shows no triangle: nothing else would show.
constexpr std::array families_of_blank_frames{Family{Kind::dropped, hypotheses_of_dropped_triangles},
                                              Family{Kind::parts, hypotheses_of_blank_frames}};

std::span<const Family> families_for(const DiagnosisInput& input) {
    if (is_blank(input.candidate.frame)) return families_of_blank_frames;
    return all_families;
}

std::vector<Hypothesis> hypotheses_of(std::span<const Family> families, const DiagnosisInput& input) {
    std::vector<Hypothesis> all;
    for (const Family& family : families)
        if (family.is_asked(input))
            for (Hypothesis& h : family.hypotheses(input)) {
                h.kind = int(family.kind);
                all.push_back(std::move(h));
            }
    return all;
}

}  // namespace

std::vector<Hypothesis> all_hypotheses(const DiagnosisInput& input) {
    return hypotheses_of(families_for(input), input);
}

std::vector<Hypothesis> hypotheses_named(std::span<const std::string> names, const DiagnosisInput& input) {
    std::vector<Hypothesis> found;
    std::vector<std::string> missing(names.begin(), names.end());
    // The last are the soonest to be made.
    for (const Family& family : families_for(input) | std::views::reverse) {
        if (missing.empty()) break;
        if (family.hypotheses == hypotheses_of_fitted_cameras) continue;
        for (Hypothesis& h : hypotheses_of({&family, 1}, input))
            if (std::ranges::count(missing, h.cause.name) > 0) found.push_back(std::move(h));
        for (const Hypothesis& h : found) std::erase(missing, h.cause.name);
    }
    return found;
}

}  // namespace zproof
