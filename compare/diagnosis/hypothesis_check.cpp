#include "compare/diagnosis/hypothesis_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "compare/adjudicate/triangle_search.h"
#include "compare/admissible/depth_rule.h"

namespace zproof {

namespace {

/// The widest step aside that a hypothesis may take within its own view, px (hypotheses/places.cpp).
constexpr double farthest_shift_px = 1;

/// Triangles beside a claim's own that are asked about to learn how much is left open.
constexpr std::size_t most_others = 32;

/// A question's claims as they were meant, less those that fail by themselves. Of a candidate that names no
/// triangles a claim stands several times, with each triangle that it may speak of.
class RestatedClaims {
  public:
    RestatedClaims(const DiagnosisInput& input, const HypothesisQuery& query)
        : scene_(input.scene),
          said_labels_(input.said),
          hypothesis_(*query.hypothesis),
          bounds_(hypothesis_.view, hypothesis_.precision),
          shown_bounds_(ViewBounds::of_shown(hypothesis_.view, hypothesis_.precision)) {
        for (std::size_t i = 0; i < query.claims.size(); ++i) {
            const std::optional<Claim> meant =
                hypothesis_.restate ? hypothesis_.restate(query.claims[i]) : query.claims[i];
            if (!meant || !(said_labels_ ? is_in_picture(*meant) : is_sound(*meant))) continue;
            claims_.push_back(*meant);
            asked_.push_back(i);
        }
        said_ = query.claims;
        detail_ = query.most_detail;
    }

    /// Puts the triangles that near(claim) lists and that may stand for the claim in its place.
    template <class Near>
    void put_triangles_for_labels(const Near& near) {
        if (!said_labels_) return;
        std::vector<Claim> claims;
        std::vector<std::size_t> asked;
        for (std::size_t i = 0; i < claims_.size(); ++i) {
            Claim claim = claims_[i];
            const PrimitiveId named = claim.answer.primitive;
            const auto add_if_sound = [&](PrimitiveId triangle) {
                claim.answer.primitive = triangle;
                if (!is_sound(claim)) return;
                claims.push_back(claim);
                asked.push_back(asked_[i]);
            };
            add_if_sound(named);
            for (const std::uint32_t t : near(claims_[i]))
                if (PrimitiveId(t) != named && have_one_label(said_labels_->labels, PrimitiveId(t), named))
                    add_if_sound(PrimitiveId(t));
        }
        claims_ = std::move(claims);
        asked_ = std::move(asked);
    }

    const Hypothesis& hypothesis() const { return hypothesis_; }
    const ViewBounds& bounds() const { return bounds_; }
    const std::vector<Claim>& claims() const { return claims_; }
    std::size_t count() const { return said_.size(); }  ///< of the query's claims
    CheckDetail most_detail() const { return detail_; }
    std::size_t asked(std::size_t i) const { return asked_[i]; }  ///< which of them claims()[i] is

    /// log2 of the depths that claims()[i]'s triangle admits.
    double depth_bits(std::size_t i) const {
        const Claim& said = said_[asked_[i]];
        if (hypothesis_.decided_depth)
            return said.answer.primitive == PrimitiveId::none
                       ? 0
                       : std::log2(floats_within(hypothesis_.decided_depth(said)));
        const Claim& claim = claims_[i];
        if (claim.answer.primitive == PrimitiveId::none) return 0;
        const ReportedDepth range = range_of(claim);
        if (range.low == -unlimited && range.high == unlimited) return 0;
        return std::log2(hypothesis_.tellable ? hypothesis_.tellable(range) : floats_within(range));
    }

  private:
    static constexpr double unlimited = std::numeric_limits<double>::infinity();

    TriangleDepth depth_of(const CornersWorld& p_world) const {
        return {TriangleInView(hypothesis_.view, shown_bounds_, p_world), shown_bounds_};
    }

    ReportedDepth range_of(const Claim& claim) const {
        const DepthBound bound = depth_of(corners_at(claim)).at(claim.x, claim.y);
        return hypothesis_.report ? hypothesis_.report(bound, claim) : ReportedDepth{bound.low, bound.high};
    }

    bool is_in_picture(const Claim& claim) const {
        return holds({hypothesis_.view.width, hypothesis_.view.height}, claim);
    }

    bool is_sound(const Claim& claim) const {
        if (!is_in_picture(claim)) return false;
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
        const TriangleDepth triangle = depth_of(p_world);
        if (hypothesis_.report) {
            const ReportedDepth reported = hypothesis_.report(triangle.at(claim.x, claim.y), claim);
            return reported.low <= depth && depth <= reported.high &&
                   (std::isfinite(depth) || !std::isfinite(reported.low));
        }
        return check_depth(view, shown_bounds_, p_world, triangle, {claim.x, claim.y}, depth).is_admissible;
    }

    const Scene& scene_;
    const SaidLabels* said_labels_;
    const Hypothesis& hypothesis_;
    ViewBounds bounds_, shown_bounds_;
    std::vector<Claim> claims_;
    std::vector<std::size_t> asked_;  ///< by claim: its place in the query
    std::span<const Claim> said_;
    CheckDetail detail_ = CheckDetail::open_bits;
};

/// The triangles that come near any pixel in question, as a scene of their own: small, so that every
/// hypothesis can be tested in it by itself. Order is kept.
class LocalScene {
  public:
    LocalScene(const DiagnosisInput& input, std::span<RestatedClaims> all_restated) {
        for (const RestatedClaims& restated : all_restated)
            for (const Claim& claim : restated.claims()) widen(input, restated, claim);
        std::vector<SearchPixel> search_pixels;
        for (const auto& [place, reach_px] : reaches_)
            search_pixels.push_back({place.second, place.first, reach_px + farthest_shift_px, {}});
        std::vector<const ViewBounds*> renderers;
        for (const RestatedClaims& restated : all_restated) renderers.push_back(&restated.bounds());
        find_nearby_triangles(input.scene, widest(input, all_restated), renderers, search_pixels);
        for (SearchPixel& search_pixel : search_pixels) {
            triangles_.insert(triangles_.end(), search_pixel.triangles.begin(), search_pixel.triangles.end());
            std::ranges::sort(search_pixel.triangles);
            nearby_[{search_pixel.y, search_pixel.x}] = std::move(search_pixel.triangles);
        }
        for (RestatedClaims& restated : all_restated)
            restated.put_triangles_for_labels([&](const Claim& claim) { return nearby(claim); });
        std::ranges::sort(triangles_);
        triangles_.erase(std::unique(triangles_.begin(), triangles_.end()), triangles_.end());
        settle(input.scene);
    }

    const Scene& scene() const { return scene_; }
    double reach_px(const Claim& claim) const { return reaches_.at({claim.y, claim.x}); }

    /// Triangles of the whole scene that come near the claim's pixel, ascending.
    const decltype(SearchPixel::triangles)& nearby(const Claim& claim) const {
        return nearby_.at({claim.y, claim.x});
    }

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
        // a triangle that stands for a label may be anywhere: those that do come near are sought
        const PrimitiveId near =
            input.said ? input.reference.frame.primitive.at(claim.x, claim.y) : claim.answer.primitive;
        double& reach = reaches_[{claim.y, claim.x}];
        reach = std::max(reach, own_eps_px(input.scene, restated.hypothesis().view, restated.bounds(),
                                           {claim.x, claim.y}, near));
    }

    /// The search looks from half the near depth on: from the nearest near plane that anyone supposes.
    static View widest(const DiagnosisInput& input, std::span<const RestatedClaims> all_restated) {
        View view = input.view;
        for (const RestatedClaims& restated : all_restated)
            view.camera.near_depth =
                std::min(view.camera.near_depth, restated.hypothesis().view.camera.near_depth);
        return view;
    }

    void settle(const Scene& whole) {
        std::vector<std::uint32_t> vertices;  // of the whole scene
        for (const std::uint32_t triangle : triangles_)
            for (int corner = 0; corner < 3; ++corner) vertices.push_back(whole.triangles[triangle][corner]);
        std::ranges::sort(vertices);
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        for (const std::uint32_t v : vertices)
            scene_.vertices.position_world.push_back(whole.vertices.position_world[v]);
        const auto here = [&](std::uint32_t v) {
            return std::uint32_t(std::ranges::lower_bound(vertices, v) - vertices.begin());
        };
        for (const std::uint32_t triangle : triangles_) {
            const glm::uvec3& t = whole.triangles[triangle];
            scene_.triangles.push_back({here(t.x), here(t.y), here(t.z)});
        }
    }

    std::map<std::pair<int, int>, double> reaches_;                           ///< by row, then column
    std::map<std::pair<int, int>, decltype(SearchPixel::triangles)> nearby_;  ///< the same
    std::vector<std::uint32_t> triangles_;
    Scene scene_;
};

/// A hundredth of the judge's work for each claim: about a hundred hypotheses are asked about it. A claim
/// that needs more is none that the hypothesis explains.
const std::size_t work_of_a_claim = Neighbourhood{}.most_work / 100;
/// As much for all other answers in its place. One that needs more is left open.
const std::size_t work_of_another = work_of_a_claim / most_others;

/// Asks the rules, but spends no more than that much work.
RuleOverride with_little_work(std::size_t most_work, RuleOverride amend) {
    return [most_work, amend = std::move(amend)](Neighbourhood& around, PrimitiveId answer) {
        around.most_work = most_work;
        if (amend) amend(around, answer);
    };
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

/// One hypothesis's claims, decided in the local scene; squares that grow beyond its reach, in the whole one.
class ClaimsInScene {
  public:
    ClaimsInScene(const DiagnosisInput& input, const LocalScene& local_scene, const RestatedClaims& restated)
        : local_scene_(local_scene),
          restated_(restated),
          own_(local_scene.scene(), restated.hypothesis().view, {&restated.bounds()},
               QueryDetail::admissibility,
               with_little_work(work_of_a_claim, in_local_scene(restated.hypothesis().amend, local_scene))),
          others_(
              local_scene.scene(), restated.hypothesis().view, {&restated.bounds()},
              QueryDetail::admissibility,
              with_little_work(work_of_another, in_local_scene(restated.hypothesis().amend, local_scene))),
          in_scene_(input.scene, restated.hypothesis().view, {&restated.bounds()}, QueryDetail::admissibility,
                    with_little_work(work_of_a_claim, restated.hypothesis().amend)) {}

    std::vector<ClaimCheck> check(CheckDetail detail) const {
        std::vector<Answered> own;
        for (std::size_t i = 0; i < restated_.claims().size(); ++i)
            own.push_back({i, restated_.claims()[i].answer.primitive});
        std::vector<ClaimCheck> checks(restated_.count());
        std::vector<std::size_t> admissible;
        for (const Answered& answered : admissible_among(own)) {
            bool& is_admissible = checks[restated_.asked(answered.claim)].is_admissible;
            if (!is_admissible) admissible.push_back(answered.claim);
            is_admissible = true;
        }
        if (std::min(detail, restated_.most_detail()) == CheckDetail::open_bits)
            tell_open_bits(admissible, checks);
        return checks;
    }

  private:
    /// An answer at the place of a claim.
    struct Answered {
        std::size_t claim = 0;
        PrimitiveId primitive = PrimitiveId::none;
    };

    struct Decided {
        const Answered* answered = nullptr;
        Decision decision;
    };

    /// Those whose triangles are in the local scene. The rest is nowhere near.
    std::vector<Decided> decided_by(const Adjudicator& adjudicator, const std::vector<Answered>& all) const {
        std::vector<PixelQuery> queries;
        std::vector<Decided> decided;
        for (const Answered& answered : all) {
            const Claim& claim = restated_.claims()[answered.claim];
            const std::optional<PrimitiveId> id = local_scene_.id_of(answered.primitive);
            if (!id) continue;
            queries.push_back({&restated_.bounds(), *id, claim.x, claim.y, AskedReason::any});
            decided.push_back({&answered, {}});
        }
        const std::vector<QueryResult> results = adjudicator.decide(queries);
        for (std::size_t i = 0; i < decided.size(); ++i) decided[i].decision = results[i].decision;
        return decided;
    }

    /// Does its square grow beyond the local scene's reach?
    bool is_beyond(const Decided& d) const {
        return d.decision.eps_px > local_scene_.reach_px(restated_.claims()[d.answered->claim]);
    }

    std::vector<Answered> admissible_among(const std::vector<Answered>& all) const {
        std::vector<PixelQuery> larger;
        std::vector<const Answered*> asked_again;
        std::vector<Answered> admissible;
        for (const Decided& d : decided_by(own_, all)) {
            const Claim& claim = restated_.claims()[d.answered->claim];
            if (is_beyond(d)) {
                larger.push_back(
                    {&restated_.bounds(), d.answered->primitive, claim.x, claim.y, AskedReason::any});
                asked_again.push_back(d.answered);
            } else if (is_admissible(d.decision.admissibility)) {
                admissible.push_back(*d.answered);
            }
        }
        const std::vector<QueryResult> decided_again = in_scene_.decide(larger);
        for (std::size_t i = 0; i < asked_again.size(); ++i)
            if (is_admissible(decided_again[i].decision.admissibility)) admissible.push_back(*asked_again[i]);
        return admissible;
    }

    /// Counts the other answers that are admissible at the claims' pixels: the triangles nearby, and
    /// background.
    void tell_open_bits(const std::vector<std::size_t>& claims, std::vector<ClaimCheck>& checks) const {
        std::vector<Answered> others;
        std::vector<double> answers(restated_.claims().size(), 1);
        for (const std::size_t i : claims) {
            const PrimitiveId own = restated_.claims()[i].answer.primitive;
            if (own != PrimitiveId::none) others.push_back({i, PrimitiveId::none});
            const auto& nearby = local_scene_.nearby(restated_.claims()[i]);
            for (const std::uint32_t triangle : std::span(nearby).first(std::min(nearby.size(), most_others)))
                if (PrimitiveId(triangle) != own) others.push_back({i, PrimitiveId(triangle)});
        }
        for (const Decided& d : decided_by(others_, others))
            if (!is_beyond(d) && !is_inadmissible(d.decision.admissibility)) ++answers[d.answered->claim];
        for (const std::size_t i : claims)
            checks[restated_.asked(i)].open_bits = std::log2(answers[i]) + restated_.depth_bits(i);
    }

    const LocalScene& local_scene_;
    const RestatedClaims& restated_;
    Adjudicator own_, others_, in_scene_;
};

}  // namespace

std::vector<std::vector<ClaimCheck>> check_claims(const DiagnosisInput& input,
                                                  std::span<const HypothesisQuery> queries,
                                                  CheckDetail detail) {
    std::vector<RestatedClaims> all_restated;
    all_restated.reserve(queries.size());
    for (const HypothesisQuery& query : queries) all_restated.emplace_back(input, query);
    const LocalScene local_scene(input, all_restated);
    std::vector<std::vector<ClaimCheck>> checks;
    for (const RestatedClaims& restated : all_restated)
        checks.push_back(ClaimsInScene(input, local_scene, restated).check(detail));
    return checks;
}

}  // namespace zproof
