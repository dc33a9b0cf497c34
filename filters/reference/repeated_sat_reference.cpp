// Windows that are n-fold boxes, texel by texel: each texel's weight is the integral of the window over it.
#include <memory>

#include "filters/reference/line_of_taps.h"

namespace zproof::oracle::filter_reference {

namespace {

constexpr int widest = 4096;

/// Steps that leave more sizes open than this permit the whole range of the texels, in which all their means
/// lie.
constexpr std::size_t most_sizes = 4;

/// The window's width in whole texels: every one that the steps may give.
std::vector<int> sides(const Interval& per_x, const Interval& per_y, int order) {
    const Interval side = length(per_x, per_y) / square_root(Interval{double(order)});
    const auto rounded = [](double a) { return a < widest ? std::max(1, int(std::floor(a + 0.5))) : widest; };
    std::vector<int> all;
    for (int w = rounded(side.low()); w <= rounded(side.high()); ++w) all.push_back(w);
    return all;
}

/// The integral of the n-fold convolution of the unit box, from where it begins to x.
double integral(double x, int order) {
    const double most = 0.5 * order, a = std::abs(x);
    if (a >= most) return x < 0 ? 0 : 1;
    if (order == 2) return x < 0 ? 0.5 * (1 + x) * (1 + x) : 1 - 0.5 * (1 - x) * (1 - x);
    const double tail = (1.5 - a) * (1.5 - a) * (1.5 - a) / 6;
    if (a >= 0.5) return x < 0 ? tail : 1 - tail;
    return 0.5 + x * (0.75 - x * x / 3);
}

struct TexelWeight {
    int texel = 0;
    double weight = 0;
};

/// The weights of an axis's texels.
struct AxisWeights {
    std::vector<TexelWeight> texels;  ///< those that count
    double off =
        0;  ///< how much weight lies elsewhere at most where the place is off by as much as it may be
};

/// A window that moves by r has at most r times its height, below 1 / w, gone from one side and come to the
/// other.
AxisWeights weights_of(const Interval& place, int side, int order, Wrap wrap, int size) {
    const double centre = middle(place), half = 0.5 * order * side;
    std::vector<double> of_texel(std::size_t(size), 0.0);
    AxisWeights weights{{}, radius(place) / side};
    for (double texel = std::floor(centre - half); texel < centre + half; ++texel) {
        const double from = integral((texel - centre) / side, order),
                     to = integral((texel + 1 - centre) / side, order);
        of_texel[std::size_t(wrapped_index(wrap, std::int64_t(texel), size))] += to - from;
        weights.off += 0x1p-50 * (1 + std::abs(centre) / side);
    }
    for (int texel = 0; texel < size; ++texel)
        if (const double weight = of_texel[std::size_t(texel)]; weight > 0)
            weights.texels.push_back({texel, weight});
    return weights;
}

class Texels {
  public:
    Texels(const texture::LinearImage& image, const Settings& settings)
        : image_(exact_image(image)), settings_(settings) {}

    PermittedColours over_windows(const FilterQuery& q, int order) const {
        const PixelFootprint f = q.footprint();
        const double error = std::exp2(-q.precision.place_bits);
        const std::vector<int> across = sides(f.per_x.u, f.per_y.u, order),
                               down = sides(f.per_x.v, f.per_y.v, order);
        if (across.size() * down.size() > most_sizes) return {image_.range};
        PermittedColours all;
        for (const int v : down)
            for (const int u : across)
                all.push_back(
                    mean(weights_of(widen(f.centre.u, error), u, order, settings_.wrap.u, image_.width),
                         weights_of(widen(f.centre.v, error), v, order, settings_.wrap.v, image_.height)));
        return all;
    }

  private:
    ColourRange mean(const AxisWeights& across, const AxisWeights& down) const {
        glm::dvec3 sum{0};
        for (const auto& [row, of_row] : down.texels) {
            glm::dvec3 line{0};
            for (const auto& [column, weight] : across.texels) line += weight * image_.at(column, row).value;
            sum += of_row * line;
        }
        constexpr double quantized = 0x1p-36;  // sums are of multiples of 2^-35
        const glm::dvec3 spread = image_.range.high - image_.range.low;
        return around(sum, (across.off + down.off) * (spread + 0x1p-40) + quantized);
    }

    IntervalImage image_;
    Settings settings_;
};

Definition repeated(const std::string& name, int order) {
    return {name, [order](const texture::LinearImage& image, const Settings& settings) -> MethodReference {
                return [texels = std::make_shared<const Texels>(image, settings),
                        order](const FilterQuery& q) { return texels->over_windows(q, order); };
            }};
}

}  // namespace

std::vector<Definition> repeated_sat_definitions() {
    return {repeated("triangle-sat", 2), repeated("quadratic-sat", 3)};
}

}  // namespace zproof::oracle::filter_reference
