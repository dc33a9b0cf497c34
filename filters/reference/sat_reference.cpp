#include <memory>

#include "filters/reference/box_mean.h"
#include "filters/reference/line_of_taps.h"

namespace zproof::oracle::filter_reference {

namespace {

/// One axis of a box about its middle, at least one texel long.
std::array<Interval, 2> at_least_one(const Interval& centre, const Interval& length_of_side) {
    const Interval half = larger(length_of_side, Interval{1}) * Interval{0.5};
    return {centre - half, centre + half};
}

Box box_around(const TexelInterval& centre, const TexelInterval& size) {
    const auto [left, right] = at_least_one(centre.u, size.u);
    const auto [top, bottom] = at_least_one(centre.v, size.v);
    return {left, right, top, bottom};
}

TexelInterval parallelogram(const PixelFootprint& f) {
    return {magnitude(f.per_x.u) + magnitude(f.per_y.u), magnitude(f.per_x.v) + magnitude(f.per_y.v)};
}

Box affine(const PixelFootprint& f) { return box_around(f.centre, parallelogram(f)); }

Box largest(const PixelFootprint& f) {
    return box_around(f.centre, {larger(magnitude(f.per_x.u), magnitude(f.per_y.u)),
                                 larger(magnitude(f.per_x.v), magnitude(f.per_y.v))});
}

Box equal_area(const PixelFootprint& f) {
    const TexelInterval size = parallelogram(f);
    const Interval shrink = square_root(area(f) / (size.u * size.v));
    return box_around(f.centre, {shrink * size.u, shrink * size.v});
}

Box moment(const PixelFootprint& f) {
    return box_around(f.centre, {length(f.per_x.u, f.per_y.u), length(f.per_x.v, f.per_y.v)});
}

/// The upright box of what a rectangle of the image shows, widened to one texel where it is smaller.
Box shown(const SeenTexture& seen, const glm::dvec2& from, const glm::dvec2& to) {
    const TexelInterval a = seen.at(from.x, from.y), b = seen.at(to.x, from.y), c = seen.at(to.x, to.y),
                        d = seen.at(from.x, to.y);
    const Interval left = smaller(smaller(a.u, b.u), smaller(c.u, d.u)),
                   right = larger(larger(a.u, b.u), larger(c.u, d.u));
    const Interval top = smaller(smaller(a.v, b.v), smaller(c.v, d.v)),
                   bottom = larger(larger(a.v, b.v), larger(c.v, d.v));
    const auto widen = [](const Interval& low, const Interval& high) -> std::array<Interval, 2> {
        if ((high - low).low() >= 1) return {low, high};
        return at_least_one(Interval{0.5} * (low + high), high - low);
    };
    const auto [l, r] = widen(left, right);
    const auto [t, m] = widen(top, bottom);
    return {l, r, t, m};
}

ColourRange over_one(const BoxMean& means, const FilterQuery& q, Box (*box)(const PixelFootprint&)) {
    return means.over(box(q.footprint()), q.precision);
}

/// The pixel cut into equal rectangles; a pixel on the plane's horizon has no quadrilateral, and takes the
/// affine box.
PermittedColours over_pieces(const BoxMean& means, const FilterQuery& q, const glm::ivec2& pieces) {
    const Interval room = q.seen.before_horizon(q.x, q.y);
    PermittedColours all;
    if (room.low() <= 0) all.push_back(over_one(means, q, affine));
    if (room.high() <= 0) return all;
    const glm::dvec2 step = 1.0 / glm::dvec2{pieces}, corner{q.x, q.y};
    ColourRange sum;
    for (int j = 0; j < pieces.y; ++j)
        for (int i = 0; i < pieces.x; ++i)
            sum = sum + means.over(shown(q.seen, corner + step * glm::dvec2(i, j),
                                         corner + step * glm::dvec2(i + 1, j + 1)),
                                   q.precision);
    all.push_back(Interval{step.x * step.y} * sum);
    return all;
}

/// Strips across the longer step, as many as the ellipse is longer than wide.
PermittedColours over_strips(const BoxMean& means, const FilterQuery& q, int most) {
    const PixelFootprint f = q.footprint();
    const Axes a = axes(f);
    const Interval x = length(f.per_x.u, f.per_x.v), y = length(f.per_y.u, f.per_y.v);
    PermittedColours all;
    for (const int n : ceilings(a.major / a.minor, most)) {
        const auto add = [&](const glm::ivec2& pieces) {
            for (const ColourRange& range : over_pieces(means, q, pieces)) all.push_back(range);
        };
        if (x.high() >= y.low()) add({n, 1});
        if (y.high() >= x.low()) add({1, n});
    }
    return all;
}

using Boxes = std::function<PermittedColours(const BoxMean&, const FilterQuery&, const Settings&)>;

Definition sat(const std::string& name, const Boxes& boxes) {
    return {"sat-" + name,
            [boxes](const texture::LinearImage& image, const Settings& settings) -> MethodReference {
                return [means = std::make_shared<const BoxMean>(image, settings.wrap, settings.more_texels),
                        settings, boxes](const FilterQuery& q) { return boxes(*means, q, settings); };
            }};
}

Definition sat_of_one(const std::string& name, Box (*box)(const PixelFootprint&)) {
    return sat(name, [box](const BoxMean& means, const FilterQuery& q, const Settings&) -> PermittedColours {
        return {over_one(means, q, box)};
    });
}

}  // namespace

std::vector<Definition> sat_definitions() {
    return {sat_of_one("affine", affine),
            sat("quad",
                [](const BoxMean& m, const FilterQuery& q, const Settings&) {
                    return over_pieces(m, q, {1, 1});
                }),
            sat_of_one("largest", largest),
            sat_of_one("area", equal_area),
            sat_of_one("moment", moment),
            sat("subquads",
                [](const BoxMean& m, const FilterQuery& q, const Settings& s) {
                    return over_pieces(m, q, {s.subdivisions, s.subdivisions});
                }),
            sat("strips", [](const BoxMean& m, const FilterQuery& q, const Settings& s) {
                return over_strips(m, q, s.max_anisotropy);
            })};
}

}  // namespace zproof::oracle::filter_reference
