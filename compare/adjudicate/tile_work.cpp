#include "compare/adjudicate/tile_work.h"

#include <algorithm>
#include <cmath>

#include "compare/admissible/displacement.h"
#include "compare/admissible/true_visibility.h"

namespace zproof {

namespace {

/// The first search radius, in own eps. Few squares grow beyond it, and a triangle that is found but meets no
/// square changes nothing.
constexpr double first_reach = 2;

/// What takes about as long as a cut of a region by a half-plane: to look where so many triangles lie, and to
/// bound so many neighbours.
constexpr std::size_t looks_per_cut = 16, neighbours_per_cut = 4;

/// Half the side of the least square around the pixel's centre that meets the box.
double distance_px_from(const Box& box, const PixelCoord& pixel) {
    const double px = pixel.x + 0.5, py = pixel.y + 0.5;
    return std::max({box.left - px, px - box.right, box.top - py, py - box.bottom, 0.0});
}

PixelCoord middle_of_tile(const PixelQuery& query) {
    constexpr int side = Tiles::side_px;
    return {query.x / side * side + side / 2, query.y / side * side + side / 2};
}

/// False, and nothing is left, where there is not so much.
bool take(std::size_t work, std::size_t& left) {
    const bool is_enough = work <= left;
    left -= std::min(work, left);
    return is_enough;
}

/// Is one end of what it may hold for its depth open?
bool is_open(const Neighbour& n, Projection projection) {
    return n.greatest_inverse_depth == unlimited ||
           n.least_inverse_depth <= (projection == Projection::perspective ? 0 : -unlimited);
}

}  // namespace

TileWork::TileWork(const Setting& setting, std::span<const std::uint32_t> near, std::size_t most_work)
    : setting_(setting),
      triangles_(setting.scene, setting.view, setting.search, near),
      around_{.view = setting.view, .neighbours = {}},
      work_left_(most_work),
      displacement_work_left_(most_work) {}

std::vector<std::uint32_t> TileWork::triangles_within(double reach_px, const PixelCoord& pixel,
                                                      const ViewBounds& bounds) {
    std::vector<std::uint32_t> within;
    for (std::size_t place = 0; place < triangles_.count(); ++place)
        if (distance_px_from(triangles_.box(place, bounds), pixel) <= reach_px)
            within.push_back(triangles_.triangle(place));
    return within;
}

/// Collects the triangles within that reach of the pixel's centre, by the renderer's bounds.
void TileWork::look_at(const PixelQuery& query, double reach_px) {
    const PixelCoord pixel{query.x, query.y};
    const Projection projection = setting_.view.camera.projection;
    if (pixel == pixel_ && reach_px == seen_px_) {
        for (auto& [place, distance_px, n] : seen_) {
            distance_px = distance_px_from(triangles_.box(place, *query.bounds), pixel);
            set_bounds(n, triangles_.of(place, *query.bounds), projection);
        }
        return;
    }
    pixel_ = pixel;
    seen_px_ = reach_px;
    seen_.clear();
    const ViewRay<double> ray = setting_.rays.at(pixel.x, pixel.y);
    for (std::size_t place = 0; place < triangles_.count(); ++place) {
        if (distance_px_from(triangles_.widest_box(place), pixel) > reach_px) continue;
        const double distance_px = distance_px_from(triangles_.box(place, *query.bounds), pixel);
        seen_.push_back({place, distance_px, neighbour_of(ray, triangles_.of(place, *query.bounds))});
        seen_.back().neighbour.triangle = triangles_.triangle(place);
    }
}

/// The eps of an answer, whether or not it is among the triangles seen.
double TileWork::own_eps_px(const PixelQuery& query) const {
    const auto found = std::ranges::find(seen_, std::uint32_t(query.answer),
                                         [](const NearTriangle& s) { return s.neighbour.triangle; });
    return found != seen_.end()
               ? found->neighbour.bounds.eps_px
               : zproof::own_eps_px(setting_.scene, setting_.view, *query.bounds, pixel_, query.answer);
}

/// The largest eps, and own_eps_px at least, of what comes within own_eps_px of the centre and whose box is
/// no farther from it than reach_px.
double TileWork::eps_px_within(double reach_px, double own_eps_px) const {
    double eps_px = own_eps_px;
    for (const auto& [place, distance_px, n] : seen_)
        if (distance_px <= reach_px && n.image && comes_within(*n.image, own_eps_px))
            eps_px = std::max(eps_px, n.bounds.eps_px);
    return eps_px;
}

void TileWork::gather(double reach_px) {
    around_.x = pixel_.x;
    around_.y = pixel_.y;
    around_.neighbours.clear();
    for (const auto& [place, distance_px, neighbour] : seen_)
        if (distance_px <= reach_px) around_.neighbours.push_back(neighbour);
}

/// Adds an answer that lies elsewhere: rounded edge functions may show it all the same.
void TileWork::add_answer(const PixelQuery& query) {
    if (query.answer == PrimitiveId::none || around_.index_of(query.answer)) return;
    const auto triangle = std::uint32_t(query.answer);
    Neighbour n =
        neighbour_of(setting_.rays.at(query.x, query.y), *query.bounds, corners_of(setting_.scene, triangle));
    n.triangle = triangle;
    if (n.may_be_shown_by_rounding())
        around_.neighbours.insert(
            std::ranges::lower_bound(around_.neighbours, triangle, {}, &Neighbour::triangle), n);
}

/// Does the square reach one of the image's sides? Clipping there puts an edge on every triangle, which errs
/// by its eps: none hides another for certain.
bool TileWork::reaches_a_side() const {
    const glm::dvec2 at = sampled_at(setting_.view, pixel_.x, pixel_.y);
    const double nearest_px = std::min({at.x, at.y, setting_.view.width - at.x, setting_.view.height - at.y});
    return nearest_px <= around_.eps_px;
}

bool TileWork::has_too_many_within(const PixelQuery& query, double reach_px) {
    return triangles_.count() > most_neighbours &&
           triangles_within(reach_px, {query.x, query.y}, *query.bounds).size() > most_neighbours;
}

/// What is shown is what was compared. Where only the depth bounds admit an answer, and where its own is
/// open, that must not lie behind what covers the pixel for certain: the farthest depth that does not.
double TileWork::farthest_depth(const PixelQuery& query, Admissibility admissibility) {
    const auto answer = around_.index_of(query.answer);
    if (std::isnan(query.depth) || !answer) return unlimited;
    if (admissibility != Admissibility::tied &&
        !is_open(around_.neighbours[*answer], setting_.view.camera.projection))
        return unlimited;
    std::vector<double> inverse_depths{query.bounds->compared_at(query.depth).greatest};
    for (const Neighbour& n : around_.neighbours)  // behind which something may hide it
        if (n.least_inverse_depth > inverse_depths.front()) inverse_depths.push_back(n.least_inverse_depth);
    if (inverse_depths.size() == 1) return unlimited;
    std::ranges::sort(inverse_depths);
    const auto is_hidden = [&](double inverse_depth) {
        const DepthDecision found = may_lie_at(inverse_depth, around_, query.answer);
        take(found.work + around_.neighbours.size() / neighbours_per_cut, work_left_);
        return !found.may_lie_there;
    };
    if (!is_hidden(inverse_depths.front())) return unlimited;
    const auto here = std::ranges::partition_point(inverse_depths, is_hidden);
    if (here == inverse_depths.end()) return unlimited;
    return setting_.view.camera.projection == Projection::perspective ? 1 / *here : -*here;
}

/// Decides by what was gathered.
void TileWork::decide_around(const PixelQuery& query, QueryResult& adjudicated) {
    const std::size_t most_work = around_.most_work,
                      at_least = around_.neighbours.size() / neighbours_per_cut;
    around_.most_work = std::min(most_work, work_left_);
    adjudicated = {.decision = zproof::decide(around_, query.answer, query.reason)};
    take(adjudicated.decision.work + at_least, work_left_);
    if (is_admissible(adjudicated.decision.admissibility))
        adjudicated.farthest_depth = farthest_depth(query, adjudicated.decision.admissibility);
    if (setting_.asked != QueryDetail::displacement || query.reason == AskedReason::any) return;
    if (adjudicated.decision.admissibility != Admissibility::visible) return;
    if (!take(at_least, displacement_work_left_)) return;
    around_.most_work = std::min(most_work, displacement_work_left_);
    const LeastDisplacement found = displacement_of(around_, query.answer);
    adjudicated.displacement_over_eps = found.over_eps;
    take(found.work, displacement_work_left_);
}

/// Is the answer what is truly at the pixel's centre, for certain? Most share that with their block, or tile,
/// which holds no other answer then.
bool TileWork::is_there_truly(const PixelQuery& query) {
    const int x = query.x % Tiles::side_px, y = query.y % Tiles::side_px;
    const std::size_t block = 1 + std::size_t(y / block_px * blocks_in_a_row + x / block_px);
    for (const auto& [place, side_px] : {std::pair{std::size_t{0}, Tiles::side_px}, {block, block_px}}) {
        std::optional<Filling>& filling = fillings_[place];
        if (!filling) filling = {query.answer, is_true_all_over(query, side_px)};
        if (filling->is_true && filling->answer == query.answer) return true;
    }
    return is_true_all_over(query, 1);
}

/// Is it so wherever a centre lies in the square of that side, of those the image is cut into, that holds the
/// pixel? What is not near the tile's queries does not matter to them.
bool TileWork::is_true_all_over(const PixelQuery& query, int side_px) {
    const int half = side_px / 2;
    const PixelCoord middle{query.x / side_px * side_px + half, query.y / side_px * side_px + half},
        seen_from = middle_of_tile(query);
    Camera camera = setting_.view.camera;
    camera.near_depth = query.bounds->near_depth();
    const std::optional<std::size_t> answer = triangles_.place_of(query.answer);
    if (!answer && query.answer != PrimitiveId::none) return false;
    const TrueVisibility visibility(
        camera, {{double(middle.x - seen_from.x), double(middle.y - seen_from.y)}, double(half)},
        answer ? &seen_in_tile(*answer, query) : nullptr);
    if (!visibility.is_answer_there()) return false;
    for (std::size_t place = 0; place < triangles_.count(); ++place)
        if (place != answer && distance_px_from(triangles_.widest_box(place), middle) <= half &&
            !visibility.is_seen_past(seen_in_tile(place, query)))
            return false;
    return true;
}

/// A triangle as seen from the tile's middle.
const Neighbour& TileWork::seen_in_tile(std::size_t place, const PixelQuery& query) {
    if (seen_in_tile_.empty()) seen_in_tile_.resize(triangles_.count());
    std::unique_ptr<Neighbour>& seen = seen_in_tile_[place];
    if (!seen) {
        const PixelCoord middle = middle_of_tile(query);
        const BoundedTriangle& triangle = triangles_.of(place, *query.bounds);
        seen = std::make_unique<Neighbour>(
            seen_at(ViewRay<double>(setting_.view, middle.x, middle.y), triangle));
        seen->may_be_missing = triangle.bounds.may_be_missing;
    }
    return *seen;
}

double TileWork::decide(const PixelQuery& query, double searched_px, QueryResult& adjudicated) {
    const bool is_work_left = take(1 + triangles_.count() / looks_per_cut, work_left_);
    if (is_work_left && query.reason == AskedReason::any && !setting_.override && is_there_truly(query)) {
        adjudicated = {};
        return 0;
    }
    if (!is_work_left || has_too_many_within(query, searched_px)) {
        adjudicated = {.decision = {Admissibility::undecidable, false, searched_px / first_reach}};
        return 0;
    }
    look_at(query, searched_px);
    const double own_eps = own_eps_px(query), least_reach_px = first_reach * own_eps;
    around_.eps_px = eps_px_within(least_reach_px, own_eps);
    const double reach_px = first_reach * around_.eps_px;
    if (reach_px > searched_px) return reach_px;
    around_.is_watertight = query.bounds->is_watertight();
    around_.clip_windows = query.bounds->clip_windows();
    around_.view.camera.near_depth = query.bounds->near_depth();
    gather(reach_px);
    add_answer(query);
    if (query.bounds->clips_at_sides() && reaches_a_side())
        std::erase_if(around_.neighbours,
                      [&](const Neighbour& n) { return PrimitiveId(n.triangle) != query.answer; });
    around_.most_work = Neighbourhood{}.most_work;
    if (setting_.override) setting_.override(around_, query.answer);
    decide_around(query, adjudicated);
    return 0;
}

}  // namespace zproof
