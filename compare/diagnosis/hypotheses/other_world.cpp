#include "compare/diagnosis/hypotheses/other_world.h"

#include <cmath>
#include <utility>

#include "compare/admissible/depth_rule.h"

namespace zproof {

namespace {

/// How far triangles are looked for around every pixel, px.
constexpr double searched_px = 1;

/// Pixels of a frame that are looked at to learn whether it may show a world.
constexpr std::size_t most_asked = 128;

const RuleOverride as_it_is;

std::vector<Box> all_tiles(const View& view) {
    const Tiles tiles(view);
    std::vector<Box> boxes;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            const double left = column * Tiles::side_px, top = row * Tiles::side_px;
            Box box{left, top, left + Tiles::side_px, top + Tiles::side_px};
            box.widen(searched_px);
            boxes.push_back(box);
        }
    return boxes;
}

}  // namespace

struct OtherWorld::Search {
    Tiles tiles;
    ViewRays<double> rays;
    std::array<const ViewBounds*, 1> renderers;
    TriangleSearch triangles;
    TrianglesByTile by_tile;
    TileWork::Setting setting;

    Search(const Scene& scene, const View& view, const ViewBounds& bounds)
        : tiles(view),
          rays(view),
          renderers{&bounds},
          triangles(scene, view, renderers),
          by_tile(triangles.find(all_tiles(view))),
          setting{scene, view, rays, triangles, QueryDetail::admissibility, as_it_is} {}

    TileWork work_at(int x, int y) const { return TileWork(setting, by_tile.of(tiles.of(x, y))); }
};

OtherWorld::OtherWorld(const DiagnosisInput& input, std::shared_ptr<const Scene> scene, const View& view)
    : input_(input),
      scene_(std::move(scene)),
      view_(view),
      bounds_(view, input.candidate.precision),
      shown_bounds_(ViewBounds::of_shown(view, input.candidate.precision)) {}

OtherWorld::~OtherWorld() = default;

OtherWorld::Search& OtherWorld::search() {
    if (!search_) search_ = std::make_unique<Search>(*scene_, view_, bounds_);
    return *search_;
}

bool OtherWorld::has(PrimitiveId id) const {
    return id == PrimitiveId::none || std::size_t(id) < scene_->triangles.size();
}

/// Looks at the claimed triangle alone.
bool OtherWorld::may_show(const Claim& claim) const {
    const PrimitiveId id = claim.answer.primitive;
    const float depth = claim.answer.camera_depth;
    if (id == PrimitiveId::none) return depth == background_depth;
    if (!has(id) || std::isnan(depth)) return false;
    if (depth < 0 && view_.camera.near_depth >= 0) return false;
    const CornersWorld p_world = corners_of(*scene_, std::uint32_t(id));
    const Neighbour seen = neighbour_of(ViewRay<double>(view_, claim.x, claim.y), bounds_, p_world);
    if (seen.image && !comes_within(*seen.image, seen.bounds.eps_px + searched_px)) return false;
    const TriangleDepth triangle(TriangleInView(view_, shown_bounds_, p_world), shown_bounds_);
    return check_depth(view_, shown_bounds_, p_world, triangle, {claim.x, claim.y}, depth).is_admissible;
}

ReportedDepth OtherWorld::depth_of(const Claim& claim) const {
    const CornersWorld p_world = corners_of(*scene_, std::uint32_t(claim.answer.primitive));
    const TriangleDepth triangle(TriangleInView(view_, shown_bounds_, p_world), shown_bounds_);
    const DepthBound bound = triangle.at(claim.x, claim.y);
    return {bound.low, bound.high};
}

bool OtherWorld::might_be_shown() {
    const Frame& frame = input_.candidate.frame;
    const std::size_t count = frame.primitive.pixels().size(), width = std::size_t(frame.size().width);
    std::vector<Claim> claims;
    for (std::size_t i = 0; i < count; i += count / most_asked + 1) {
        const int x = int(i % width), y = int(i / width);
        if (frame.primitive.at(x, y) != PrimitiveId::none)
            claims.push_back({x, y, {frame.primitive.at(x, y), frame.camera_depth.at(x, y)}});
    }
    std::size_t possible = 0, impossible = 0;
    for (std::size_t i = 0; 2 * possible < claims.size() && 2 * impossible <= claims.size(); ++i) {
        const bool is_possible = std::ranges::any_of(readings_of(claims[i]),
                                                     [&](const Claim& reading) { return may_show(reading); });
        ++(is_possible ? possible : impossible);
    }
    return 2 * possible >= claims.size();
}

std::vector<Claim> OtherWorld::readings_of(const Claim& claim) {
    if (!input_.said) return {claim};
    std::vector<Claim> readings;
    if (claim.answer.primitive == PrimitiveId::none) readings.push_back(claim);
    const Search& in = search();
    const Box near = square_around(claim.x, claim.y, searched_px);
    for (const std::uint32_t t : in.by_tile.of(in.tiles.of(claim.x, claim.y)))
        if (in.triangles.box_of(t).meets(near) &&
            have_one_label(input_.said->labels, PrimitiveId(t), claim.answer.primitive))
            readings.push_back({claim.x, claim.y, {PrimitiveId(t), claim.answer.camera_depth}});
    return readings;
}

bool OtherWorld::admits(const Claim& claim) {
    if (!may_show(claim) || search().by_tile.triangles.empty()) return false;
    QueryResult result;
    const PixelQuery query{&bounds_, claim.answer.primitive, claim.x, claim.y, AskedReason::any};
    const double needed_px = search().work_at(claim.x, claim.y).decide(query, searched_px, result);
    return needed_px == 0 && is_admissible(result.decision.admissibility);
}

Neighbourhood OtherWorld::around(const Claim& claim, double reach_px) {
    TileWork work = search().work_at(claim.x, claim.y);
    const SearchPixel pixel{claim.x, claim.y, reach_px,
                            work.triangles_within(reach_px, {claim.x, claim.y}, bounds_)};
    return neighbourhood_of(*scene_, view_, bounds_, pixel, bounds_.background_eps_px());
}

namespace {

Hypothesis explains_nothing(const DiagnosisInput& input, Cause cause) {
    Hypothesis h = as_declared(input, std::move(cause));
    h.restate = [](const Claim&) -> std::optional<Claim> { return std::nullopt; };
    return h;
}

}  // namespace

std::shared_ptr<const Scene> declared_scene(const DiagnosisInput& input) {
    return {std::shared_ptr<const Scene>(), &input.scene};
}

Hypothesis decided(const DiagnosisInput& input, Cause cause,
                   std::function<std::optional<ReportedDepth>(const Claim&)> admitted) {
    Hypothesis h = as_declared(input, std::move(cause));
    h.restate = [admitted](const Claim& claim) -> std::optional<Claim> {
        if (!admitted(claim)) return std::nullopt;
        return Claim{claim.x, claim.y, {PrimitiveId::none, background_depth}};
    };
    h.amend = [](Neighbourhood& around, PrimitiveId) { around.neighbours.clear(); };
    h.decided_depth = [admitted = std::move(admitted)](const Claim& claim) { return *admitted(claim); };
    return h;
}

Hypothesis decided_by(const DiagnosisInput& input, Cause cause, const std::shared_ptr<OtherWorld>& world,
                      std::function<bool(const Claim&)> admits,
                      std::function<ReportedDepth(const Claim&)> depth_of) {
    return decided(input, std::move(cause),
                   [world, admits = std::move(admits),
                    depth_of = std::move(depth_of)](const Claim& claim) -> std::optional<ReportedDepth> {
                       for (const Claim& reading : world->readings_of(claim)) {
                           if (!world->has(reading.answer.primitive) || !admits(reading)) continue;
                           const bool is_background = reading.answer.primitive == PrimitiveId::none;
                           return is_background ? ReportedDepth{} : depth_of(reading);
                       }
                       return std::nullopt;
                   });
}

Hypothesis shown_instead(const DiagnosisInput& input, Cause cause, std::shared_ptr<const Scene> scene,
                         const View& view) {
    const auto world = std::make_shared<OtherWorld>(input, std::move(scene), view);
    if (!world->might_be_shown()) return explains_nothing(input, std::move(cause));
    return decided_by(
        input, std::move(cause), world, [world](const Claim& claim) { return world->admits(claim); },
        [world](const Claim& claim) { return world->depth_of(claim); });
}

}  // namespace zproof
