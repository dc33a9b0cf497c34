#include "lessons/projection/accuracy.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lessons/projection/routes.h"

namespace zproof::study::projection {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Exact = Point2<Rational>;

enum class CanvasRegion { on_canvas, off_canvas, behind_eye };

/// What one route, in one type, made of one vertex.
struct Outcome {
    std::vector<double> costs_px;  ///< by operation; empty where no number came out
    VertexError error{nan, nan};
    bool is_on_canvas = false;  ///< by its own word
    double pixel_x = nan, pixel_y = nan;
    int lost_at = -1;  ///< index of the operation; -1: the pixel is right
};

struct Vertex {
    std::uint32_t index = 0;
    CanvasRegion place = CanvasRegion::behind_eye;
    bool is_on_pixel_border = false;
    double x = 0, y = 0, depth = 0;
    int pixel_x = 0, pixel_y = 0;
    std::vector<Outcome> outcomes;
};

/// A route in a machine type and in exact arithmetic.
template <class Number>
struct RoutePair {
    Route<Number> rounded;
    Route<Rational> exact;
};

template <class Number>
std::vector<RoutePair<Number>> route_pairs(const View& view) {
    const auto rounded = routes(camera_of<Number>(view));
    const auto exact = routes(camera_of<Rational>(view));
    std::vector<RoutePair<Number>> both;
    // The canvas about the axis is found by an equation that rounding keeps: both lists hold the same routes.
    for (std::size_t i = 0; i < std::min(rounded.size(), exact.size()); ++i)
        if (rounded[i].card.kind == RouteKind::lesson && rounded[i].card.name == exact[i].card.name)
            both.push_back({rounded[i], exact[i]});
    return both;
}

Rational floor_of(const Rational& a) {
    using boost::multiprecision::mpz_int;
    const mpz_int numerator = boost::multiprecision::numerator(a),
                  denominator = boost::multiprecision::denominator(a);
    mpz_int quotient = numerator / denominator;  // towards 0
    if (a.sign() < 0 && quotient * denominator != numerator) quotient -= 1;
    return Rational(quotient);
}

double in_double(const Rational& a) { return static_cast<double>(a); }

double larger_difference(const Exact& a, const Exact& b) {
    return in_double(std::max(magnitude(a.x - b.x), magnitude(a.y - b.y)));
}

template <class Number>
bool is_finite(const Travel<Number>& t) {
    return std::ranges::all_of(t.at, [](Number a) { return std::isfinite(a); }) &&
           std::isfinite(t.screen.x) && std::isfinite(t.screen.y);
}

template <class Number>
Travel<Rational> exactly_there(const Travel<Number>& t) {
    Travel<Rational> exact;
    for (std::size_t i = 0; i < 4; ++i) exact.at[i] = Rational(t.at[i]);
    exact.screen = {Rational(t.screen.x), Rational(t.screen.y)};
    return exact;
}

/// The place that exact arithmetic leads to from here; nothing where it would have to divide by 0.
std::optional<Exact> exact_end(const Route<Rational>& route, const Travel<Rational>& travel,
                               std::size_t from) try {
    const Travel<Rational> end = arrival(route, travel, from);
    return Exact{end.at[0], end.at[1]};
} catch (const std::overflow_error&) {
    return std::nullopt;
}

/// Distance of neighbouring numbers of the type at this magnitude.
template <class Number>
double last_place(const Rational& a) {
    int exponent = 0;
    std::frexp(in_double(magnitude(a)), &exponent);
    constexpr int digits = std::numeric_limits<Number>::digits,
                  least = std::numeric_limits<Number>::min_exponent;
    return std::ldexp(1.0, std::max(exponent, least) - digits);
}

template <class Number>
VertexError error_of(const Exact& exact, const Exact& got) {
    return {larger_difference(got, exact),
            std::max(in_double(magnitude(got.x - exact.x)) / last_place<Number>(exact.x),
                     in_double(magnitude(got.y - exact.y)) / last_place<Number>(exact.y))};
}

bool is_pixel(const Exact& p, const Vertex& vertex) {
    return floor_of(p.x) == vertex.pixel_x && floor_of(p.y) == vertex.pixel_y;
}

/// Ends after each operation, the exact one first; empty where one is no number.
template <class Number>
std::vector<Exact> ends_of(const RoutePair<Number>& route_pair, const Vector3<Number>& p_world) {
    std::vector<Exact> ends;
    Travel<Number> travel = departure(p_world);
    for (std::size_t i = 0;; ++i) {
        if (!is_finite(travel)) return {};
        const auto end = exact_end(route_pair.exact, exactly_there(travel), i);
        if (!end) return {};
        ends.push_back(*end);
        if (i == route_pair.rounded.operations.size()) return ends;
        travel = route_pair.rounded.operations[i].apply(travel);
    }
}

template <class Number>
bool calls_on_canvas(const View& view, const Travel<Number>& end) {
    const bool is_before = view.camera.projection == Projection::parallel || end.at[2] > 0;
    return is_before && end.at[0] >= 0 && end.at[0] <= Number(view.width) && end.at[1] >= 0 &&
           end.at[1] <= Number(view.height);
}

/// Matrices carry NDC depth, not camera depth, to raster space; their w is the depth.
template <class Number>
bool calls_on_canvas(const View& view, const RoutePair<Number>& route_pair, const Vector3<Number>& p_world) {
    Travel<Number> travel = departure(p_world);
    Number depth = 1;
    for (const Operation<Number>& operation : route_pair.rounded.operations) {
        travel = operation.apply(travel);
        if (operation.arrives == Space::clip) depth = travel.at[3];
        if (operation.arrives == Space::screen || operation.arrives == Space::screen_at_one)
            depth = travel.at[2];
    }
    travel.at[2] = depth;
    return calls_on_canvas(view, travel);
}

template <class Number>
void follow(const View& view, const std::vector<RoutePair<Number>>& all, const glm::vec3& p, Vertex& vertex) {
    const Vector3<Number> p_world{Number(p.x), Number(p.y), Number(p.z)};
    for (const RoutePair<Number>& route_pair : all) {
        Outcome outcome;
        outcome.is_on_canvas = calls_on_canvas(view, route_pair, p_world);
        const std::vector<Exact> ends =
            vertex.place == CanvasRegion::on_canvas ? ends_of(route_pair, p_world) : std::vector<Exact>{};
        for (std::size_t i = 1; i < ends.size(); ++i) {
            outcome.costs_px.push_back(larger_difference(ends[i], ends[i - 1]));
            if (is_pixel(ends[i - 1], vertex)) outcome.lost_at = int(i) - 1;
        }
        if (!ends.empty()) {
            outcome.error = error_of<Number>(ends.front(), ends.back());
            outcome.pixel_x = in_double(floor_of(ends.back().x));
            outcome.pixel_y = in_double(floor_of(ends.back().y));
            if (is_pixel(ends.back(), vertex)) outcome.lost_at = -1;
        }
        vertex.outcomes.push_back(std::move(outcome));
    }
}

bool is_whole(const Rational& a) { return boost::multiprecision::denominator(a) == 1; }

/// The exact place, by the first route.
Vertex placed(const View& view, const Route<Rational>& route, const NumericCamera<Rational>& camera,
              const glm::vec3& p) {
    Vertex vertex;
    const Vector3<Rational> p_world = exactly<Rational>(glm::dvec3(p));
    const Rational depth = -dot(camera.to_camera[2], p_world - camera.eye);
    vertex.depth = in_double(depth);
    if (camera.projection == Projection::perspective && depth <= 0) return vertex;
    const Travel<Rational> end = arrival(route, departure(p_world));
    const Rational &x = end.at[0], &y = end.at[1];
    const bool is_on = x >= 0 && x <= view.width && y >= 0 && y <= view.height;
    vertex.place = is_on ? CanvasRegion::on_canvas : CanvasRegion::off_canvas;
    if (!is_on) return vertex;
    vertex.x = in_double(x), vertex.y = in_double(y);
    vertex.pixel_x = int(in_double(floor_of(x))), vertex.pixel_y = int(in_double(floor_of(y)));
    vertex.is_on_pixel_border = is_whole(x) || is_whole(y);
    return vertex;
}

/// Every k-th of the finite vertices, with the least whole k that keeps to `most`.
std::vector<std::uint32_t> chosen(const Positions& positions, std::size_t most, std::uint64_t& not_finite) {
    std::vector<std::uint32_t> finite;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::vec3& p = positions[i];
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
            finite.push_back(std::uint32_t(i));
    }
    not_finite = positions.size() - finite.size();
    const std::size_t step = std::max<std::size_t>(1, (finite.size() + most - 1) / most);
    std::vector<std::uint32_t> thinned;
    for (std::size_t i = 0; i < finite.size(); i += step) thinned.push_back(finite[i]);
    return thinned;
}

Spread spread_of(std::vector<double> values) {
    std::erase_if(values, [](double v) { return std::isnan(v); });
    if (values.empty()) return {};
    std::ranges::sort(values);
    const auto at = [&](double share) { return values[std::size_t(share * double(values.size() - 1))]; };
    return {at(0.5), at(0.99), values.back()};
}

template <class Number>
void name_routes(const std::vector<RoutePair<Number>>& all, const std::string& numbers,
                 ViewAccuracy& accuracy) {
    for (const RoutePair<Number>& route_pair : all) {
        RouteScore score;
        score.route = route_pair.rounded.card.name, score.numbers = numbers;
        for (const Operation<Number>& operation : route_pair.rounded.operations)
            score.operations.push_back({operation.stage, operation.name});
        accuracy.routes.push_back(std::move(score));
    }
}

void count_place(const Vertex& vertex, ViewAccuracy& accuracy) {
    ++accuracy.studied;
    if (vertex.place == CanvasRegion::behind_eye) ++accuracy.behind_eye;
    if (vertex.place == CanvasRegion::off_canvas) ++accuracy.off_canvas;
    if (vertex.place == CanvasRegion::on_canvas) ++accuracy.on_canvas;
    if (vertex.is_on_pixel_border) ++accuracy.on_pixel_border;
}

LostPixel lost_pixel(const Vertex& vertex, const Outcome& outcome, const RouteScore& score) {
    const OperationScore& operation = score.operations[std::size_t(outcome.lost_at)];
    return {.vertex = vertex.index,
            .route = score.route,
            .numbers = score.numbers,
            .x = vertex.x,
            .y = vertex.y,
            .pixel_x = vertex.pixel_x,
            .pixel_y = vertex.pixel_y,
            .got_x = outcome.pixel_x,
            .got_y = outcome.pixel_y,
            .error_px = outcome.error.px,
            .stage = operation.stage,
            .operation = operation.operation};
}

/// The outcome of one vertex, for one route's score.
void count_outcome(const Vertex& vertex, const Outcome& outcome, RouteScore& score, ViewAccuracy& accuracy) {
    const bool is_on = vertex.place == CanvasRegion::on_canvas;
    if (outcome.is_on_canvas != is_on) ++score.other_side;
    if (!is_on) return;
    if (outcome.costs_px.empty()) ++score.no_number;
    for (std::size_t i = 0; i < outcome.costs_px.size(); ++i) {
        score.operations[i].mean_px += outcome.costs_px[i];
        score.operations[i].largest_px = std::max(score.operations[i].largest_px, outcome.costs_px[i]);
    }
    if (outcome.lost_at < 0) return;
    ++score.other_pixel;
    ++score.operations[std::size_t(outcome.lost_at)].pixels_lost;
    accuracy.lost.push_back(lost_pixel(vertex, outcome, score));
}

void finish_scores(const std::vector<Vertex>& vertices, ViewAccuracy& accuracy) {
    for (std::size_t r = 0; r < accuracy.routes.size(); ++r) {
        RouteScore& score = accuracy.routes[r];
        std::vector<double> px, ulp;
        for (const Vertex& vertex : vertices) {
            count_outcome(vertex, vertex.outcomes[r], score, accuracy);
            if (vertex.place != CanvasRegion::on_canvas) continue;
            px.push_back(vertex.outcomes[r].error.px), ulp.push_back(vertex.outcomes[r].error.ulp);
        }
        const double numbers = double(accuracy.on_canvas - score.no_number);
        for (OperationScore& operation : score.operations) operation.mean_px /= std::max(1.0, numbers);
        score.px = spread_of(std::move(px)), score.ulp = spread_of(std::move(ulp));
    }
    std::ranges::stable_sort(accuracy.lost, std::ranges::greater{}, &LostPixel::error_px);
}

VertexRow row_of(const Vertex& vertex) {
    VertexRow row{vertex.index, vertex.x, vertex.y, vertex.depth, {}};
    for (const Outcome& outcome : vertex.outcomes) row.errors.push_back(outcome.error);
    return row;
}

}  // namespace

ViewAccuracy accuracy_of(const Scene& scene, const View& view, std::size_t most) {
    const Positions& positions = scene.vertices.position_world;
    ViewAccuracy accuracy;
    accuracy.vertices = positions.size();
    const std::vector<std::uint32_t> indices = chosen(positions, most, accuracy.not_finite);
    const auto single = route_pairs<float>(view);
    const auto twice = route_pairs<double>(view);
    const NumericCamera<Rational> camera = camera_of<Rational>(view);
    std::vector<Vertex> vertices(indices.size());
    tbb::parallel_for(std::size_t{0}, indices.size(), [&](std::size_t i) {
        const glm::vec3& p = positions[indices[i]];
        vertices[i] = placed(view, single.front().exact, camera, p);
        vertices[i].index = indices[i];
        follow(view, single, p, vertices[i]);
        follow(view, twice, p, vertices[i]);
    });
    name_routes(single, "float32", accuracy);
    name_routes(twice, "float64", accuracy);
    for (const Vertex& vertex : vertices) {
        count_place(vertex, accuracy);
        if (vertex.place == CanvasRegion::on_canvas) accuracy.rows.push_back(row_of(vertex));
    }
    finish_scores(vertices, accuracy);
    return accuracy;
}

}  // namespace zproof::study::projection
