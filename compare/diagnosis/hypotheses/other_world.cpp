#include "compare/diagnosis/hypotheses/other_world.h"

#include <cmath>
#include <utility>

#include "compare/admissible/depth_rule.h"

namespace zproof {

namespace {

/// How far triangles are looked for around every pixel, px.
constexpr double searched_px = 1;

/// Pixels of a frame that are looked at before anything is searched.
constexpr std::size_t most_asked = 512;

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

OtherWorld::OtherWorld(std::shared_ptr<const Scene> scene, const View& view, const Precision& precision)
    : scene_(std::move(scene)),
      view_(view),
      bounds_(view, precision),
      shown_bounds_(view, shown_precision(precision)) {}

OtherWorld::~OtherWorld() = default;

OtherWorld::Search& OtherWorld::search() {
    if (!search_) search_ = std::make_unique<Search>(*scene_, view_, bounds_);
    return *search_;
}

/// Looks at the claimed triangle alone.
bool OtherWorld::may_show(const Claim& claim) const {
    const PrimitiveId id = claim.answer.primitive;
    const float depth = claim.answer.camera_depth;
    if (id == PrimitiveId::none) return depth == background_depth;
    if (std::size_t(id) >= scene_->triangles.size() || std::isnan(depth)) return false;
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

bool OtherWorld::might_be_shown_in(const Frame& frame) const {
    const std::size_t count = frame.primitive.pixels().size(), width = std::size_t(frame.size().width);
    std::size_t asked = 0, possible = 0;
    for (std::size_t i = 0; i < count; i += count / most_asked + 1) {
        const int x = int(i % width), y = int(i / width);
        if (frame.primitive.at(x, y) == PrimitiveId::none) continue;
        ++asked;
        possible += may_show({x, y, {frame.primitive.at(x, y), frame.camera_depth.at(x, y)}});
    }
    return 2 * possible >= asked;
}

bool OtherWorld::admits(const Claim& claim) {
    if (!may_show(claim) || search().by_tile.triangles.empty()) return false;
    QueryResult result;
    const PixelQuery query{&bounds_, claim.answer.primitive, claim.x, claim.y};
    const double needed_px = search().work_at(claim.x, claim.y).decide(query, searched_px, result);
    return needed_px == 0 && is_admissible(result.decision.admissibility);
}

Neighbourhood OtherWorld::around(const Claim& claim, double reach_px) {
    TileWork work = search().work_at(claim.x, claim.y);
    const SearchPixel pixel{claim.x, claim.y, reach_px,
                            work.triangles_within(reach_px, {claim.x, claim.y}, bounds_)};
    return neighbourhood_of(*scene_, view_, bounds_, pixel, bounds_.background_eps_px());
}

std::shared_ptr<const Scene> declared_scene(const DiagnosisInput& input) {
    return {std::shared_ptr<const Scene>(), &input.scene};
}

Hypothesis decided_by(const DiagnosisInput& input, Cause cause, std::function<bool(const Claim&)> admits,
                      std::function<ReportedDepth(const Claim&)> depth_of) {
    Hypothesis h = as_declared(input, std::move(cause));
    h.restate = [admits = std::move(admits)](const Claim& claim) -> std::optional<Claim> {
        if (!admits(claim)) return std::nullopt;
        return Claim{claim.x, claim.y, {PrimitiveId::none, background_depth}};
    };
    h.amend = [](Neighbourhood& around, PrimitiveId) { around.neighbours.clear(); };
    h.decided_depth = std::move(depth_of);
    return h;
}

Hypothesis shown_instead(const DiagnosisInput& input, Cause cause, std::shared_ptr<const Scene> scene,
                         const View& view) {
    const auto world = std::make_shared<OtherWorld>(std::move(scene), view, input.candidate.precision);
    return decided_by(
        input, std::move(cause),
        [world, is_possible = world->might_be_shown_in(input.candidate.frame)](const Claim& claim) {
            return is_possible && world->admits(claim);
        },
        [world](const Claim& claim) { return world->depth_of(claim); });
}

}  // namespace zproof
