#include "reports/pictures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include "reports/class_style.h"

namespace zproof {

namespace {

constexpr Rgb8 background_colour{0x14, 0x16, 0x1A};
constexpr Rgb8 no_depth_colour{0xFF, 0x00, 0xFF};
constexpr int undotted_side = 240;  // pages show pictures at least this wide

/// Equal neighbours are looked up once.
template <class T, class Colour>
Plane<Rgb8> coloured(const Plane<T>& values, Colour colour) {
    Plane<Rgb8> picture(values.size());
    tbb::parallel_for(0, values.size().height, [&](int y) {
        const std::span<const T> row = values.row(y);
        const std::span<Rgb8> to = picture.row(y);
        for (std::size_t x = 0; x < row.size(); ++x)
            to[x] = x > 0 && row[x] == row[x - 1] ? to[x - 1] : colour(row[x]);
    });
    return picture;
}

/// Bijective, so different ids stay different: the finalizer of MurmurHash3.
std::uint32_t scrambled(std::uint32_t h) {
    h = (h ^ (h >> 16)) * 0x85EB'CA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2'AE35u;
    return h ^ (h >> 16);
}

/// Rounded to nearest; not by std::lround, which costs more than the rest of a picture.
std::uint8_t channel(double value) { return std::uint8_t(255 * std::clamp(value, 0.0, 1.0) + 0.5); }

/// A colour per id. What hue, saturation and value can be is worked out once.
class IdColours {
  public:
    IdColours() {
        for (std::size_t i = 0; i < 256; ++i) {
            saturation_[i] = 0.35 + 0.3 * double(i) / 255;
            value_[i] = 0.6 + 0.38 * double(i) / 255;
        }
    }
    Rgb8 operator()(PrimitiveId id) const {
        if (id == PrimitiveId::none) return background_colour;
        const std::uint32_t h = scrambled(static_cast<std::uint32_t>(id) + 1);
        return from_hsv((h & 0xFFFF) / 65536.0, saturation_[h >> 16 & 0xFF], value_[h >> 24]);
    }

  private:
    /// Hue in turns, [0, 1); saturation and value in [0, 1] (Smith 1978).
    static Rgb8 from_hsv(double hue, double saturation, double value) {
        const auto one = [&](double shift) {
            const double turned = shift + 6 * hue, k = turned - (turned < 6 ? 0.0 : 6.0);
            return channel(value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0)));
        };
        return {one(5), one(3), one(1)};
    }

    std::array<double, 256> saturation_, value_;
};

/// std::lerp for positive ends and t in [0, 1], without its other cases.
double between(double from, double to, double t) {
    const double there = from + t * (to - from);
    return from < to ? std::min(there, to) : std::max(there, to);
}

/// Viridis (van der Walt and Smith, 2015) in nine steps; t in [0, 1], 1 bright.
Rgb8 viridis(double t) {
    constexpr std::array<std::array<double, 3>, 9> stops{{{68, 1, 84},
                                                          {71, 45, 123},
                                                          {59, 82, 139},
                                                          {44, 114, 142},
                                                          {33, 145, 140},
                                                          {40, 174, 128},
                                                          {94, 201, 98},
                                                          {173, 220, 48},
                                                          {253, 231, 37}}};
    const double place = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
    const std::size_t low = std::min(std::size_t(place), stops.size() - 2);
    const auto mix = [&](std::size_t c) {
        return channel(between(stops[low][c], stops[low + 1][c], place - double(low)) / 255);
    };
    return {mix(0), mix(1), mix(2)};
}

/// The sRGB transfer function (IEC 61966-2-1).
std::uint8_t srgb(float linear) {
    const double c = std::clamp(double{linear}, 0.0, 1.0);
    return channel(c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

Rgb8 colour_of_light(const LinearRgb& c) {
    if (std::isnan(c.r) || std::isnan(c.g) || std::isnan(c.b)) return no_depth_colour;
    return {srgb(c.r), srgb(c.g), srgb(c.b)};
}

bool is_depth(float depth) { return std::isfinite(depth) && depth > 0; }

struct LogRange {
    double low = 0, high = 0;
};

LogRange log_range(const Plane<float>& depths) {
    float low = background_depth, high = 0;
    for (const float depth : depths.pixels()) {
        if (!is_depth(depth)) continue;
        low = std::min(low, depth);
        high = std::max(high, depth);
    }
    return high > 0 ? LogRange{std::log(low), std::log(high)} : LogRange{};
}

template <class Visit>
void for_each_pixel(Resolution size, Visit visit) {
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) visit(x, y);
}

Resolution shrunk(Resolution size, int factor) {
    return {(size.width + factor - 1) / factor, (size.height + factor - 1) / factor};
}

}  // namespace

Plane<Rgb8> picture_of_ids(const Plane<PrimitiveId>& ids) { return coloured(ids, IdColours{}); }

Plane<Rgb8> picture_of_depths(const Plane<float>& depths) {
    const LogRange range = log_range(depths);
    return coloured(depths, [&](float depth) {
        if (depth == background_depth) return background_colour;
        if (!is_depth(depth)) return no_depth_colour;
        const double span = range.high - range.low;
        return viridis(span > 0 ? (range.high - std::log(depth)) / span : 0.7);
    });
}

Plane<Rgb8> picture_of_light(const Picture& picture) { return coloured(picture, colour_of_light); }

Plane<Rgb8> picture_of_difference(const Picture& a, const Picture& b) {
    Plane<Rgb8> picture(a.size());
    std::ranges::transform(
        a.pixels(), b.pixels(), picture.pixels().begin(), [](const LinearRgb& p, const LinearRgb& q) {
            const double d = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
            return std::isnan(d) ? no_depth_colour : d == 0 ? background_colour : viridis(std::sqrt(d));
        });
    return picture;
}

Plane<Rgb8> picture_of_classes(const Plane<PixelClass>& classes) {
    return coloured(classes, [](PixelClass c) { return style_of(c).colour; });
}

int shrink_factor(Resolution size) {
    return std::max(1, (std::max(size.width, size.height) + small_side - 1) / small_side);
}

Plane<Rgb8> thinned(const Plane<Rgb8>& picture, int factor) {
    const Resolution full = picture.size();
    Plane<Rgb8> small(shrunk(full, factor));
    for_each_pixel(small.size(), [&](int x, int y) {
        small.at(x, y) = picture.at(std::min(x * factor + factor / 2, full.width - 1),
                                    std::min(y * factor + factor / 2, full.height - 1));
    });
    return small;
}

Plane<PixelClass> pooled_by_severity(const Plane<PixelClass>& classes, int factor) {
    Plane<PixelClass> small(shrunk(classes.size(), factor), PixelClass::agree);
    for (int y = 0; y < classes.size().height; ++y) {
        const std::span<const PixelClass> row = classes.row(y);
        const std::span<PixelClass> blocks = small.row(y / factor);
        for (std::size_t x = 0; x < row.size(); ++x)
            if (row[x] != PixelClass::agree)
                blocks[x / std::size_t(factor)] = std::max(blocks[x / std::size_t(factor)], row[x]);
    }
    return small;
}

Plane<PixelClass> with_dots(const Plane<PixelClass>& classes) {
    Plane<PixelClass> dotted = classes;
    const Resolution size = classes.size();
    for_each_pixel(size, [&](int x, int y) {
        const PixelClass c = classes.at(x, y);
        if (passes(c)) return;
        for (int j = std::max(0, y - 1); j <= std::min(size.height - 1, y + 1); ++j)
            for (int i = std::max(0, x - 1); i <= std::min(size.width - 1, x + 1); ++i)
                dotted.at(i, j) = std::max(dotted.at(i, j), c);
    });
    return dotted;
}

Plane<PixelClass> small_class_map(const Plane<PixelClass>& classes) {
    const Plane<PixelClass> small = pooled_by_severity(classes, shrink_factor(classes.size()));
    const bool may_shrink = std::max(small.size().width, small.size().height) > undotted_side;
    return may_shrink ? with_dots(small) : small;
}

}  // namespace zproof