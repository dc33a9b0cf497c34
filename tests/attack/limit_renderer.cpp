#include "tests/attack/limit_renderer.h"

#include <bit>
#include <cmath>
#include <map>

#include "tests/attack/fixed_edges.h"
#include "tests/attack/lot.h"

namespace zproof::attack {

namespace {

/// Of a triangle that is cut; each moves by itself where nothing else is promised.
constexpr std::size_t most_pieces = 16;

/// The same number for corners at the same place: what is one corner in the scene moves as one.
std::uint64_t lot_of(const Image<double>& image, std::size_t corner, std::size_t piece,
                     const Limits& limits) {
    std::uint64_t lot = mixed(limits.seed, limits.sharing == Sharing::apart ? piece + 1 : 0);
    lot = mixed(lot, std::bit_cast<std::uint64_t>(image[corner].x + 0.0));
    return mixed(lot, std::bit_cast<std::uint64_t>(image[corner].y + 0.0));
}

std::int64_t floor_of(const Number& a) {
    using boost::multiprecision::mpz_int;
    mpz_int quotient, rest;
    boost::multiprecision::divide_qr(mpz_int(numerator(a)), mpz_int(denominator(a)), quotient, rest);
    if (rest < 0) --quotient;
    return quotient.convert_to<std::int64_t>();
}
std::int64_t ceiling_of(const Number& a) { return -floor_of(-a); }

/// Where a coordinate goes, in steps; it moves up where `up`.
class Mover {
  public:
    Mover(const Allowance& allowance, Movement movement)
        : movement_(movement),
          eps_(Number(allowance.eps_px) * fixed_one),
          grid_(fixed_one >> allowance.subpixel_bits) {}

    std::int64_t operator()(const Number& px, bool up) const {
        const Number at = px * fixed_one;
        switch (movement_) {
            case Movement::stay:
                return floor_of(at + Number(1) / 2);
            case Movement::nearest_grid: {
                const Number in_grid = at / grid_ + Number(1) / 2;
                return (up ? floor_of(in_grid) : ceiling_of(in_grid) - 1) * grid_;
            }
            case Movement::beside_grid:
                return (up ? ceiling_of(at / grid_) : floor_of(at / grid_)) * grid_;
            default:
                return up ? floor_of(at + eps_) : ceiling_of(at - eps_);
        }
    }

  private:
    Movement movement_;
    Number eps_;
    std::int64_t grid_;
};

struct Ways {
    bool right, down;
};

Ways ways_of(const Image<double>& image, std::size_t corner, std::size_t piece, const Limits& limits) {
    Place<double> middle;
    for (const auto& c : image)
        middle.x += c.x / double(image.size()), middle.y += c.y / double(image.size());
    const Ways outwards{image[corner].x > middle.x, image[corner].y > middle.y};
    const std::uint64_t lot = limits.movement == Movement::one_way
                                  ? mixed(limits.seed, limits.sharing == Sharing::apart ? piece : 0)
                                  : lot_of(image, corner, piece, limits);
    switch (limits.movement) {
        case Movement::grow:
            return outwards;
        case Movement::shrink:
            return {!outwards.right, !outwards.down};
        default:
            return {(lot & 1) != 0, (lot & 2) != 0};
    }
}

/// The least float from `a` up, and the greatest up to it.
float float_from(double a) {
    const auto f = float(a);
    return double(f) < a ? std::nextafterf(f, HUGE_VALF) : f;
}
float float_up_to(double a) { return -float_from(-a); }

/// A surface at a pixel, and the depths that it may be given there.
struct Fragment {
    std::uint32_t triangle;
    double depth;
    float least, greatest;
};

class Drawing {
  public:
    Drawing(const ExactScene& scene, const Allowance& allowance, const Limits& limits)
        : scene_(scene),
          allowance_(allowance),
          limits_(limits),
          move_(allowance, limits.movement),
          moved_of_(),
          fragments_({scene.view().width, scene.view().height}, {}) {}

    Frame frame() {
        for (std::size_t t = 0; t < scene_.size(); ++t) draw(t);
        Frame frame(fragments_.size());
        for (int y = 0; y < fragments_.size().height; ++y)
            for (int x = 0; x < fragments_.size().width; ++x) show(frame, x, y);
        return frame;
    }

  private:
    FixedPoint moved(std::size_t triangle, std::size_t corner, std::size_t piece) {
        const ExactImage& image = scene_.image(triangle);
        const Ways ways = ways_of(scene_.rounded(triangle), corner, most_pieces * triangle + piece, limits_);
        const bool is_alike = limits_.sharing == Sharing::alike;
        const std::pair key{scene_.rounded(triangle)[corner].x, scene_.rounded(triangle)[corner].y};
        if (is_alike)
            if (const auto known = moved_of_.find(key); known != moved_of_.end()) return known->second;
        const FixedPoint at{move_(image[corner].x, ways.right), move_(image[corner].y, ways.down)};
        if (is_alike) moved_of_.emplace(key, at);
        return at;
    }

    void draw(std::size_t triangle) {
        const Image<double>& image = scene_.rounded(triangle);
        if (image.size() < 3) return;
        // cuts far beside the picture are none of the renderer's: they part nothing
        const bool is_in_pieces = scene_.is_near_by(triangle);
        for (std::size_t i = 2; i < image.size(); ++i) {
            const std::size_t piece = is_in_pieces ? i : 0;
            draw_piece(triangle,
                       {moved(triangle, 0, piece), moved(triangle, i - 1, piece), moved(triangle, i, piece)},
                       {image[0].front, image[i - 1].front, image[i].front});
        }
    }

    void draw_piece(std::size_t triangle, const FixedTriangle& piece, const std::array<double, 3>& front) {
        const FixedEdges edges(piece, limits_.edge_owner);
        const PixelBox box = edges.box(scene_.view());
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x)
                if (const auto weights = edges.weights_at(fixed_sample(scene_.view(), x, y))) {
                    double sum = 0, greatest = 0;
                    for (std::size_t i = 0; i < 3; ++i) {
                        sum += (*weights)[i] * front[i];
                        greatest = std::max(greatest, std::abs(scene_.depth(front[i])));
                    }
                    add(triangle, x, y, scene_.depth(sum), greatest);
                }
    }

    /// A depth was computed in double, with less than 16 roundings of numbers up to `greatest`.
    void add(std::size_t triangle, int x, int y, double depth, double greatest) {
        const double known =
            0x1p-49 * std::max(std::abs(depth),
                               scene_.view().camera.projection == Projection::parallel ? greatest : 0.0);
        const double error =
            std::max(0.0, allowance_.depth_relative * std::abs(depth) + allowance_.depth_absolute - known);
        Fragment fragment{std::uint32_t(triangle), depth, float_from(depth - error),
                          float_up_to(depth + error)};
        if (limits_.depth_error == DepthError::none || fragment.least > fragment.greatest)
            fragment.least = fragment.greatest = float(depth);
        if (limits_.depth_error == DepthError::nearest) fragment.greatest = fragment.least;
        if (limits_.depth_error == DepthError::farthest) fragment.least = fragment.greatest;
        if (scene_.view().camera.near_depth >= 0) {
            fragment.least = std::max(fragment.least, 0x1p-126f);
            fragment.greatest = std::max(fragment.greatest, 0x1p-126f);
        }
        fragments_.at(x, y).push_back(fragment);
    }

    /// The farthest surface of those that need not lie behind another, at one end of what it may say.
    void show(Frame& frame, int x, int y) {
        const auto& here = fragments_.at(x, y);
        if (here.empty()) return;
        float limit = HUGE_VALF;
        for (const Fragment& f : here) limit = std::min(limit, f.greatest);
        const Fragment* shown = nullptr;
        for (const Fragment& f : here)
            if (f.least <= limit && (!shown || f.depth > shown->depth)) shown = &f;
        const bool says_least = (mixed(limits_.seed, std::uint64_t(y) << 32 | std::uint64_t(x)) & 1) != 0;
        frame.primitive.at(x, y) = PrimitiveId(shown->triangle);
        frame.camera_depth.at(x, y) = says_least ? shown->least : std::min(shown->greatest, limit);
    }

    const ExactScene& scene_;
    Allowance allowance_;
    Limits limits_;
    Mover move_;
    std::map<std::pair<double, double>, FixedPoint> moved_of_;
    Plane<std::vector<Fragment>> fragments_;
};

template <class Value>
std::string word(const Value& value, std::initializer_list<const char*> words) {
    return words.begin()[std::size_t(value)];
}

}  // namespace

std::string text_of(const Limits& limits) {
    return word(limits.movement,
                {"stay", "one_way", "any_corner", "grow", "shrink", "nearest_grid", "beside_grid"}) +
           " " + word(limits.sharing, {"alike", "apart"}) + ", depth " +
           word(limits.depth_error, {"none", "nearest", "farthest", "reversed"}) + ", edges " +
           word(limits.edge_owner, {"all", "top_left", "bottom_right"}) + ", planes " +
           word(limits.plane_cut, {"outwards", "exact", "inwards"}) + ", seed " + std::to_string(limits.seed);
}

Allowance allowance_of(const BoundedPrecision& precision, const View& view) {
    const Camera& c = view.camera;
    const double of_range =
        precision.depth_of_range > 0 ? precision.depth_of_range * (c.far_depth - c.near_depth) : 0;
    return {.eps_px = precision.eps_px,
            .depth_relative = precision.depth_relative,
            .depth_absolute = precision.depth_absolute + of_range};
}

Allowance allowance_of(const RasterPrecision& precision) {
    return {.subpixel_bits = precision.subpixel_bits, .depth_relative = precision.depth_roundings * 0x1p-24};
}

Planes planes_of(const View& view, const Allowance& allowance, PlaneCut cut) {
    Planes planes = planes_of(view);
    if (cut == PlaneCut::exact) return planes;
    const int outwards = cut == PlaneCut::outwards ? 1 : -1;
    const auto error_at = [&](const Number& plane) {
        return Number(outwards * (Number(allowance.depth_relative) * absolute(plane) +
                                  Number(allowance.depth_absolute)));
    };
    const Number near = planes.near - error_at(planes.near);
    if (view.camera.projection == Projection::parallel || near > 0) planes.near = near;
    if (planes.far) *planes.far += error_at(*planes.far);
    return planes;
}

Frame draw_at_limits(const ExactScene& scene, const Allowance& allowance, const Limits& limits) {
    return Drawing(scene, allowance, limits).frame();
}

}  // namespace zproof::attack
