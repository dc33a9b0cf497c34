#include "compare/diagnosis/hypothesis_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compare/adjudicate/triangle_search.h"
#include "compare/admissible/depth_rule.h"

namespace zproof {

namespace {

/// The widest step aside that a hypothesis may take within its own view, px (hypotheses/places.cpp).
constexpr double farthest_shift_px = 1;

/// A question's claims as they were meant, less those that fail by themselves.
class RestatedClaims {
  public:
    RestatedClaims(const DiagnosisInput& input, const HypothesisQuery& query)
        : scene_(input.scene),
          hypothesis_(*query.hypothesis),
          bounds_(hypothesis_.view, hypothesis_.precision),
          shown_bounds_(hypothesis_.view, shown_precision(hypothesis_.precision)) {
        for (const Claim& claim : query.claims) {
            const std::optional<Claim> meant = hypothesis_.restate ? hypothesis_.restate(claim) : claim;
            if (meant && is_sound(*meant)) claims_.push_back(*meant);
        }
    }

    const Hypothesis& hypothesis() const { return hypothesis_; }
    const ViewBounds& bounds() const { return bounds_; }
    const std::vector<Claim>& claims() const { return claims_; }

  private:
    bool is_sound(const Claim& claim) const {
        if (!holds({hypothesis_.view.width, hypothesis_.view.height}, claim)) return false;
        const PrimitiveId id = claim.answer.primitive;
        if (id == PrimitiveId::none) return claim.answer.camera_depth == background_depth;
        return is_triangle(id) && has_admissible_depth(claim);
    }

    bool is_triangle(PrimitiveId id) const { return std::size_t(id) < scene_.triangles.size(); }

    CornersWorld corners_at(const Claim& claim) const {
        return corners_of(scene_, std::uint32_t(claim.answer.primitive));
    }

    bool has_admissible_depth(const Claim& claim) const {
        const float depth = claim.answer.camera_depth;
        const CornersWorld p_world = corners_at(claim);
        const View& view = hypothesis_.view;
        const TriangleDepth triangle(TriangleInView(view, shown_bounds_, p_world), shown_bounds_);
        if (hypothesis_.report) {
            const ReportedDepth reported = hypothesis_.report(triangle.at(claim.x, claim.y), claim);
            return reported.low <= depth && depth <= reported.high;
        }
        return depth >= 0 &&
               check_depth(view, shown_bounds_, p_world, triangle, {claim.x, claim.y}, depth).is_admissible;
    }

    const Scene& scene_;
    const Hypothesis& hypothesis_;
    ViewBounds bounds_, shown_bounds_;
    std::vector<Claim> claims_;
};

/// The triangles that come near any pixel in question, as a scene of their own: small, so that every
/// hypothesis can be tested in it by itself. Order is kept; vertices are not shared, since corners are told
/// by their positions.
class LocalScene {
  public:
    LocalScene(const DiagnosisInput& input, std::span<const RestatedClaims> all_restated) {
        for (const RestatedClaims& restated : all_restated)
            for (const Claim& claim : restated.claims()) widen(input, restated, claim);
        std::vector<SearchPixel> search_pixels;
        for (const auto& [place, reach_px] : reaches_)
            search_pixels.push_back({place.second, place.first, reach_px + farthest_shift_px, {}});
        std::vector<const ViewBounds*> renderers;
        for (const RestatedClaims& restated : all_restated) renderers.push_back(&restated.bounds());
        find_nearby_triangles(input.scene, widest(input, all_restated), renderers, search_pixels);
        for (const SearchPixel& search_pixel : search_pixels)
            triangles_.insert(triangles_.end(), search_pixel.triangles.begin(), search_pixel.triangles.end());
        std::ranges::sort(triangles_);
        triangles_.erase(std::unique(triangles_.begin(), triangles_.end()), triangles_.end());
        for (const std::uint32_t triangle : triangles_) settle(corners_of(input.scene, triangle));
    }

    const Scene& scene() const { return scene_; }
    double reach_px(const Claim& claim) const { return reaches_.at({claim.y, claim.x}); }

    PrimitiveId id_in_scene(std::uint32_t triangle) const { return PrimitiveId(triangles_[triangle]); }

    /// The triangle's id within the local scene; nothing where it comes near no place in question.
    std::optional<PrimitiveId> id_of(PrimitiveId primitive) const {
        if (primitive == PrimitiveId::none) return primitive;
        const auto found = std::ranges::lower_bound(triangles_, std::uint32_t(primitive));
        if (found == triangles_.end() || *found != std::uint32_t(primitive)) return std::nullopt;
        return PrimitiveId(found - triangles_.begin());
    }

  private:
    void widen(const DiagnosisInput& input, const RestatedClaims& restated, const Claim& claim) {
        const double own = own_eps_px(input.scene, restated.hypothesis().view, restated.bounds(),
                                      {claim.x, claim.y}, claim.answer.primitive);
        double& reach = reaches_[{claim.y, claim.x}];
        reach = std::max(reach, own);
    }

    /// The search looks from half the near depth on: from the nearest near plane that anyone supposes.
    static View widest(const DiagnosisInput& input, std::span<const RestatedClaims> all_restated) {
        View view = input.view;
        for (const RestatedClaims& restated : all_restated)
            view.camera.near_depth =
                std::min(view.camera.near_depth, restated.hypothesis().view.camera.near_depth);
        return view;
    }

    void settle(const CornersWorld& p_world) {
        const auto first = std::uint32_t(scene_.vertices.position_world.size());
        for (const glm::vec3& p : p_world) scene_.vertices.position_world.push_back(p);
        scene_.triangles.push_back({first, first + 1, first + 2});
    }

    std::map<std::pair<int, int>, double> reaches_;  ///< by row, then column
    std::vector<std::uint32_t> triangles_;
    Scene scene_;
};

std::uint64_t admissible_among(std::span<const QueryResult> adjudicated) {
    return std::uint64_t(std::ranges::count_if(
        adjudicated, [](const QueryResult& a) { return is_admissible(a.decision.admissibility); }));
}

/// Rules of drawing speak of the scene's ids.
RuleOverride in_local_scene(const RuleOverride& amend, const LocalScene& local_scene) {
    if (!amend) return nullptr;
    return [&](Neighbourhood& around, PrimitiveId answer) {
        for (Neighbour& n : around.neighbours)
            n.triangle = std::uint32_t(local_scene.id_in_scene(n.triangle));
        const bool background = answer == PrimitiveId::none;
        amend(around, background ? answer : local_scene.id_in_scene(std::uint32_t(answer)));
        for (Neighbour& n : around.neighbours)
            n.triangle = std::uint32_t(*local_scene.id_of(PrimitiveId(n.triangle)));
    };
}

/// Squares that grow beyond the local scene's reach are judged in the whole scene.
std::uint64_t count_admissible(const DiagnosisInput& input, const LocalScene& local_scene,
                               const RestatedClaims& restated) {
    const Hypothesis& supposed = restated.hypothesis();
    std::vector<PixelQuery> queries, larger;
    std::vector<const Claim*> asked;
    for (const Claim& claim : restated.claims()) {
        const std::optional<PrimitiveId> id = local_scene.id_of(claim.answer.primitive);
        if (!id) continue;
        queries.push_back({&restated.bounds(), *id, claim.x, claim.y});
        asked.push_back(&claim);
    }
    std::vector<QueryResult> adjudicated =
        Adjudicator(local_scene.scene(), supposed.view, {&restated.bounds()}, QueryDetail::admissibility,
                    in_local_scene(supposed.amend, local_scene))
            .decide(queries);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (adjudicated[i].decision.eps_px <= local_scene.reach_px(*asked[i])) continue;
        adjudicated[i].decision.admissibility = Admissibility::outside;
        larger.push_back({&restated.bounds(), asked[i]->answer.primitive, asked[i]->x, asked[i]->y});
    }
    return admissible_among(adjudicated) +
           admissible_among(Adjudicator(input.scene, supposed.view, {&restated.bounds()},
                                        QueryDetail::admissibility, supposed.amend)
                                .decide(larger));
}

}  // namespace

std::vector<std::uint64_t> count_admissible(const DiagnosisInput& input,
                                            std::span<const HypothesisQuery> hypothesis_queries) {
    std::vector<RestatedClaims> all_restated;
    all_restated.reserve(hypothesis_queries.size());
    for (const HypothesisQuery& query : hypothesis_queries) all_restated.emplace_back(input, query);
    const LocalScene local_scene(input, all_restated);
    std::vector<std::uint64_t> counts;
    for (const RestatedClaims& restated : all_restated)
        counts.push_back(count_admissible(input, local_scene, restated));
    return counts;
}

double mean_widening(const DiagnosisInput& input, const HypothesisQuery& query) {
    const Hypothesis& supposed = *query.hypothesis;
    const ViewBounds declared(input.view, shown_precision(input.candidate.precision)),
        supposed_bounds(supposed.view, shown_precision(supposed.precision));
    double sum = 0, count = 0;
    for (const Claim& claim : query.claims) {
        if (std::size_t(claim.answer.primitive) >= input.scene.triangles.size()) continue;
        const CornersWorld p_world = corners_of(input.scene, std::uint32_t(claim.answer.primitive));
        const auto bound_in = [&](const View& view, const ViewBounds& bounds) {
            return TriangleDepth(TriangleInView(view, bounds, p_world), bounds).at(claim.x, claim.y);
        };
        const DepthBound declared_bound = bound_in(input.view, declared),
                         bound = bound_in(supposed.view, supposed_bounds);
        const ReportedDepth reported =
            supposed.report ? supposed.report(bound, claim) : ReportedDepth{bound.low, bound.high};
        const double wider =
            std::log((reported.high - reported.low) / (declared_bound.high - declared_bound.low));
        if (!std::isfinite(wider)) continue;
        sum += wider;
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

}  // namespace zproof
