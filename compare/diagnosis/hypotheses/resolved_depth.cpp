#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/other_world.h"
#include "compare/diagnosis/hypotheses/plane_depth.h"
#include "math/rounding.h"
#include "scenes/standard_samples.h"

namespace zproof {

namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// Where a pixel is looked at, px from its centre.
using Places = std::vector<glm::dvec2>;

Places of_samples(int count) {
    Places places;
    for (const Sample& sample : standard_samples(count)) places.push_back(sample.offset_px);
    return places;
}

Places of_grid(int n) {
    Places places;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) places.push_back((glm::dvec2(x, y) + 0.5) / double(n) - 0.5);
    return places;
}

/// What may be seen at one place: a depth within the range, or nothing. Nothing alone: low is infinite.
struct SeenDepth {
    double low = nowhere, high = nowhere;
    bool may_be_nothing = true;

    bool may_be_something() const { return low < nowhere; }
};

/// Where more triangles come near a pixel, its depth is not explained.
constexpr std::size_t most_in_a_pixel = 64;

/// The depths that are seen at places of one pixel after another.
class DepthsInPixels {
  public:
    explicit DepthsInPixels(const DiagnosisInput& input)
        : world_(input, declared_scene(input), input.view),
          camera_(input.view.camera),
          seen_(input.reference.frame.primitive) {}

    std::vector<SeenDepth> at(int x, int y, const Places& places) {
        const auto [entry, is_new] = around_.try_emplace({x, y});
        if (is_new) entry->second = world_.around({x, y, {}}, 1);
        if (entry->second.neighbours.size() > most_in_a_pixel) entry->second.neighbours.clear();
        const bool is_amid = is_amid_triangles(x, y);
        std::vector<SeenDepth> all;
        for (const glm::dvec2& offset : places) {
            all.push_back(seen_at(entry->second, offset));
            all.back().may_be_nothing &= !is_amid || !all.back().may_be_something();
        }
        return all;
    }

  private:
    /// Does the reference see no background beside the pixel? Then the pixel has none.
    bool is_amid_triangles(int x, int y) const {
        for (int ny = y - 1; ny <= y + 1; ++ny)
            for (int nx = x - 1; nx <= x + 1; ++nx)
                if (holds(seen_.size(), {nx, ny, {}}) && seen_.at(nx, ny) == PrimitiveId::none) return false;
        return true;
    }

    SeenDepth seen_at(const Neighbourhood& around, const glm::dvec2& offset) const {
        double low = nowhere, certain = nowhere, possible = -nowhere;
        for (const Neighbour& n : around.neighbours) {
            if (!n.image) continue;
            double inside = nowhere;  // in eps
            for (const Affine<double>& e : n.image->edge)
                inside = std::min(inside, (e.c + e.a * offset.x + e.b * offset.y) /
                                              (around.eps_px * (std::abs(e.a) + std::abs(e.b))));
            const ReportedDepth depth = plane_depth(n, camera_.projection, offset);
            if (inside < -1 || !(depth.low <= camera_.far_depth) || depth.high < camera_.near_depth) continue;
            low = std::min(low, std::max(depth.low, camera_.near_depth));
            possible = std::max(possible, depth.high);
            const bool is_certain = inside >= 1 && !n.may_be_missing && depth.low >= camera_.near_depth &&
                                    depth.high <= camera_.far_depth;
            if (is_certain) certain = std::min(certain, depth.high);
        }
        return {low, std::min(certain, possible), certain == nowhere};
    }

    OtherWorld world_;
    Camera camera_;
    const Plane<PrimitiveId>& seen_;
    std::map<std::pair<int, int>, Neighbourhood> around_;
};

/// One depth of several; background is left out.
enum class Resolve { first, least, greatest, mean, mean_of_z };

/// Depths of which none may be background.
ReportedDepth resolved_certain(const std::vector<SeenDepth>& seen, Resolve resolve, bool is_perspective) {
    ReportedDepth range{nowhere, nowhere};
    if (resolve == Resolve::greatest) range = {-nowhere, -nowhere};
    double low = 0, high = 0;
    const bool is_inverse = resolve == Resolve::mean_of_z && is_perspective;
    for (const SeenDepth& s : seen) {
        const auto pick = [&](double a, double b) {
            return resolve == Resolve::greatest ? std::max(a, b) : std::min(a, b);
        };
        range = {pick(range.low, s.low), pick(range.high, s.high)};
        low += (is_inverse ? 1 / s.low : s.low) / double(seen.size());
        high += (is_inverse ? 1 / s.high : s.high) / double(seen.size());
    }
    if (resolve == Resolve::least || resolve == Resolve::greatest) return range;
    return is_inverse ? ReportedDepth{1 / low, 1 / high} : ReportedDepth{low, high};
}

ReportedDepth resolved(std::vector<SeenDepth> seen, Resolve resolve, bool is_perspective) {
    if (resolve == Resolve::first) return {seen.front().low, seen.front().high};
    std::erase_if(seen, [](const SeenDepth& s) { return !s.may_be_something(); });
    if (seen.empty()) return {nowhere, nowhere};
    ReportedDepth range = resolved_certain(seen, resolve, is_perspective);
    std::vector<SeenDepth> certain = seen;
    std::erase_if(certain, [](const SeenDepth& s) { return s.may_be_nothing; });
    if (certain.size() < seen.size()) {  // which of them count is not known: one depth lies among them
        for (const SeenDepth& s : seen) range = {std::min(range.low, s.low), std::max(range.high, s.high)};
        if (!certain.empty() && resolve == Resolve::least)
            range.high = resolved_certain(certain, resolve, is_perspective).high;
        if (!certain.empty() && resolve == Resolve::greatest)
            range.low = resolved_certain(certain, resolve, is_perspective).low;
    }
    const double rounding = gamma(int(seen.size()) + 4, unit_roundoff_float32);
    return {range.low - rounding * std::abs(range.low), range.high + rounding * std::abs(range.high)};
}

/// The id is the centre's, the depth is made of those at several places of the pixel.
Hypothesis of_places(const DiagnosisInput& input, const std::shared_ptr<DepthsInPixels>& depths,
                     const Places& places, Resolve resolve, Cause cause) {
    Hypothesis h = as_declared(input, std::move(cause));
    const bool is_perspective = input.view.camera.projection == Projection::perspective;
    const auto range_at = [=](const Claim& claim) {
        return resolved(depths->at(claim.x, claim.y, places), resolve, is_perspective);
    };
    h.report = [range_at](const DepthBound&, const Claim& claim) { return range_at(claim); };
    const bool tells_ids = !input.said || !input.said->labels.are_absent;
    h.restate = [range_at, tells_ids,
                 &seen = input.reference.frame.primitive](const Claim& claim) -> std::optional<Claim> {
        const double depth = double(claim.answer.camera_depth);
        const PrimitiveId id = tells_ids ? claim.answer.primitive : seen.at(claim.x, claim.y);
        if (id != PrimitiveId::none || std::isinf(depth)) return claim;
        const ReportedDepth range = range_at(claim);
        if (!(range.low <= depth && depth <= range.high)) return std::nullopt;
        return Claim{claim.x, claim.y, {PrimitiveId::none, background_depth}, claim.label};
    };
    return h;
}

constexpr const char* resolve_state =
    "Look at the multisample resolve: a depth must be one sample's, that of the id's.";

std::vector<Hypothesis> of_pattern(const DiagnosisInput& input, const std::shared_ptr<DepthsInPixels>& depths,
                                   const Places& places, const std::string& name) {
    const auto of = [&](Resolve resolve, const std::string& which, const std::string& description) {
        return of_places(
            input, depths, places, resolve,
            {"depth is the " + which + " of " + name,
             description + " Background is left out, and the id is the centre's.", resolve_state});
    };
    return {of(Resolve::mean, "mean", "Depth is the mean over samples of the pixel."),
            of(Resolve::mean_of_z, "mean z", "Depth is turned back from the mean of z over samples."),
            of(Resolve::least, "least", "Depth is the nearest of the pixel's samples."),
            of(Resolve::greatest, "greatest", "Depth is the farthest of the pixel's samples."),
            of(Resolve::first, "first", "Depth is that of the first sample.")};
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_resolved_depth(const DiagnosisInput& input) {
    if (input.view.sample.offset_px != glm::dvec2(0)) return {};
    const auto depths = std::make_shared<DepthsInPixels>(input);
    std::vector<Hypothesis> all;
    for (const int count : {2, 4, 8})
        for (Hypothesis& h : of_pattern(input, depths, of_samples(count), std::to_string(count) + " samples"))
            all.push_back(std::move(h));
    for (const int n : {2, 3, 4, 8, 16}) {
        const std::string places = std::to_string(n) + " x " + std::to_string(n) + " places";
        all.push_back(of_places(
            input, depths, of_grid(n), Resolve::mean,
            {"depth is averaged over the pixel",
             "Depth is the mean over " + places + " in the pixel; background is left out.", resolve_state}));
    }
    return all;
}

}  // namespace zproof
