/// Convex polygons in the image: distances in the largest coordinate, as a promise about x and y counts them.
/// N is Rational where the answer decides, double where it only chooses.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace zproof::attack {

template <class N>
struct Place {
    N x{}, y{};  ///< raster, px
};

/// A corner of what is seen of a triangle.
template <class N>
struct ImageCorner {
    N x{}, y{};
    N front{};  ///< 1 / camera depth; parallel: minus the depth. Affine in the image, and greater in front
};

/// Corners in order; all on one line where the triangle is seen edge-on, none where nothing is seen.
template <class N>
using Image = std::vector<ImageCorner<N>>;

template <class N>
struct Extremes {
    N least{}, greatest{};
};

template <class N>
N absolute(const N& a) {
    return a < 0 ? N(-a) : a;
}

/// Twice the signed area to the left of the line from a to b.
template <class N>
N side_of(const ImageCorner<N>& a, const ImageCorner<N>& b, const Place<N>& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

template <class N>
N twice_area(const Image<N>& image) {
    N sum = 0;
    for (std::size_t i = 2; i < image.size(); ++i)
        sum += side_of(image[0], image[i - 1], Place<N>{image[i].x, image[i].y});
    return sum;
}

/// Does the closed polygon hold p? One without area holds nothing.
template <class N>
bool covers(const Image<N>& image, const Place<N>& p) {
    const N area = twice_area(image);
    if (area == 0) return false;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const N side = side_of(image[i], image[(i + 1) % image.size()], p);
        if (area > 0 ? side < 0 : side > 0) return false;
    }
    return true;
}

/// How far p lies within the polygon: half the side of the largest square around it that the polygon covers.
/// 0 where it does not hold p.
template <class N>
N inset_of(const Image<N>& image, const Place<N>& p) {
    if (!covers(image, p)) return 0;
    std::optional<N> least;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const ImageCorner<N>&a = image[i], &b = image[(i + 1) % image.size()];
        const N steps = absolute<N>(b.x - a.x) + absolute<N>(b.y - a.y);
        if (steps == 0) continue;
        const N distance = absolute<N>(side_of(a, b, p)) / steps;
        if (!least || distance < *least) least = distance;
    }
    return *least;
}

/// From p to the side from a to b.
template <class N>
N distance_to_side(const ImageCorner<N>& a, const ImageCorner<N>& b, const Place<N>& p) {
    const N x = a.x - p.x, y = a.y - p.y, across = b.x - a.x, down = b.y - a.y;
    const auto at = [&](const N& share) {
        return std::max<N>(absolute<N>(x + across * share), absolute<N>(y + down * share));
    };
    N least = std::min<N>(at(N(0)), at(N(1)));
    // the larger of two distances is least at an end, where one of them is 0, or where they are equal
    const std::array<std::array<N, 2>, 4> zeros{
        {{x, across}, {y, down}, {N(x - y), N(across - down)}, {N(x + y), N(across + down)}}};
    for (const auto& [offset, slope] : zeros) {
        if (slope == 0) continue;
        const N share = -offset / slope;
        if (share > 0 && share < 1) least = std::min<N>(least, at(share));
    }
    return least;
}

/// Half the side of the least square around p that meets the polygon; none where nothing is seen of it.
template <class N>
std::optional<N> distance_to(const Image<N>& image, const Place<N>& p) {
    if (image.empty()) return std::nullopt;
    if (covers(image, p)) return N(0);
    std::optional<N> least;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const N distance = distance_to_side(image[i], image[(i + 1) % image.size()], p);
        if (!least || distance < *least) least = distance;
    }
    return least;
}

/// The part where value(corner) >= 0; value is affine in the image.
template <class N, class Value>
Image<N> part_where(const Image<N>& image, const Value& value) {
    Image<N> kept;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const ImageCorner<N>&a = image[i], &b = image[(i + 1) % image.size()];
        const N at_a = value(a), at_b = value(b);
        if (at_a >= 0) kept.push_back(a);
        if ((at_a >= 0) == (at_b >= 0)) continue;
        const N share = at_a / (at_a - at_b);
        kept.push_back(
            {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share, a.front + (b.front - a.front) * share});
    }
    return kept;
}

/// What of it lies in the closed square around p.
template <class N>
Image<N> part_in_square(Image<N> image, const Place<N>& p, const N& half_side) {
    using Corner = ImageCorner<N>;
    image = part_where<N>(image, [&](const Corner& c) { return N(c.x - p.x + half_side); });
    image = part_where<N>(image, [&](const Corner& c) { return N(p.x + half_side - c.x); });
    image = part_where<N>(image, [&](const Corner& c) { return N(c.y - p.y + half_side); });
    return part_where<N>(image, [&](const Corner& c) { return N(p.y + half_side - c.y); });
}

/// Of `front` over the polygon's part in the square; none where it does not come so near.
template <class N>
std::optional<Extremes<N>> front_in_square(const Image<N>& image, const Place<N>& p, const N& half_side) {
    std::optional<Extremes<N>> extremes;
    for (const ImageCorner<N>& c : part_in_square(image, p, half_side)) {
        if (!extremes) extremes = {c.front, c.front};
        extremes->least = std::min<N>(extremes->least, c.front);
        extremes->greatest = std::max<N>(extremes->greatest, c.front);
    }
    return extremes;
}

/// The value of `front` at p, by the plane of the polygon; none where it is seen edge-on.
template <class N>
std::optional<N> front_at(const Image<N>& image, const Place<N>& p) {
    if (image.size() < 3) return std::nullopt;
    // three corners that are not on one line
    for (std::size_t i = 2; i < image.size(); ++i) {
        const ImageCorner<N>&a = image[0], &b = image[i - 1], &c = image[i];
        const N area = side_of(a, b, Place<N>{c.x, c.y});
        if (area == 0) continue;
        const N of_c = side_of(a, b, p) / area, of_b = side_of(c, a, p) / area;
        return N(a.front + (b.front - a.front) * of_b + (c.front - a.front) * of_c);
    }
    return std::nullopt;
}

/// What of a triangle's plane counts for its depth at a pixel.
enum class DepthFrom {
    square,    ///< all of the square, as docs/bounds.md has it
    own_part,  ///< only the triangle's own part of it: no displaced triangle has depths beyond
};

/// Of `front`; none where there is no plane, or nothing of the triangle in the square.
template <class N>
std::optional<Extremes<N>> front_range(const Image<N>& image, const Place<N>& p, const N& half_side,
                                       DepthFrom from) {
    if (from == DepthFrom::own_part) return front_in_square(image, p, half_side);
    const auto here = front_at(image, p), right = front_at(image, Place<N>{N(p.x + 1), p.y}),
               below = front_at(image, Place<N>{p.x, N(p.y + 1)});
    if (!here) return std::nullopt;
    const N reach = half_side * (absolute<N>(*right - *here) + absolute<N>(*below - *here));
    return Extremes<N>{N(*here - reach), N(*here + reach)};
}

}  // namespace zproof::attack
