/// The depth study: which error a depth buffer leaves, how small a gap it keeps in order, and which format
/// keeps the gap that one needs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lessons/depth/gap.h"
#include "lessons/depth/scene_error.h"
#include "scenes/loaded.h"

namespace zproof::study::depth {

/// A format's errors on one scene where near moves: far stays beyond all that is seen.
struct LadderRow {
    Format format;
    std::vector<double> p99;  ///< by DepthStudy::ratios, shares of the depth; NaN where no pixel is left
};

/// How much of the picture fights, by the distance between two layers.
struct FightingCurve {
    Format format;
    std::vector<double> share;  ///< by DepthStudy::deltas, 0 to 1
};

/// The cheapest formats that keep a gap in order everywhere between near and far; those in [-1, 1] are never
/// better than their likes in [0, 1] and left out.
struct Choice {
    double ratio = 0;                ///< far / near
    double gap_of_far = 0;           ///< the gap wanted, as a share of far
    std::vector<std::string> names;  ///< of the fewest bits that do; empty where none does
};

/// A format's worst gap for planes that somebody asked about.
struct WorstGap {
    Format format;
    double gap = 0;      ///< scene units; +inf where the format cannot hold the planes
    bool holds = false;  ///< gap <= the gap asked for
};

struct DepthStudy {
    std::string scene, view;
    Planes planes;  ///< the view's own; far brought in behind all that is seen where it is infinite
    Resolution size;
    std::size_t pixels = 0, left_out = 0;
    double nearest = 0, farthest = 0, median = 0;  ///< depths seen, scene units
    std::vector<ErrorSpread> spreads;              ///< every interpolation and format, by the view's planes
    std::vector<double> ratios;                    ///< far / near
    std::vector<LadderRow> ladder;
    std::vector<double> pixels_left;  ///< by ratio: the share of the pixels seen that lie beyond near
    std::vector<double> deltas;       ///< scene units, falling
    std::vector<FightingCurve> fighting;
};

/// What holds for no scene in particular.
struct GapStudy {
    std::vector<GapCurve> curves;  ///< every format at every ratio, 1/d interpolated; near is 1
    std::vector<GapCurve> ways;    ///< interpolations that are right, on a few formats, at one ratio
    std::vector<Choice> choices;
};

/// 10, 100, ... 1e7.
std::vector<double> ladder_ratios();

/// Announces each unit of work as it begins.
using Announce = std::function<void(const std::string& what)>;

/// Throws as seen_in(). The same figures for any number of threads.
DepthStudy study_depth(const Scene& scene, const View& view, const Announce& announce);

GapStudy study_gaps(const Announce& announce);

/// Every format's worst gap between these planes, the fewest bits first, beside the gap that is wanted.
std::vector<WorstGap> worst_gaps(const Planes& planes, double wanted);

/// Announcements of study_depth and of study_gaps.
int units_of_depth();
int units_of_gaps();

}  // namespace zproof::study::depth
