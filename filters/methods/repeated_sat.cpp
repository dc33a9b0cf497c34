#include <array>
#include <cmath>
#include <memory>

#include "filters/methods/families.h"
#include "filters/methods/tap_rule.h"
#include "filters/stored/repeated_sums.h"

namespace zproof::texture {

namespace {

/// The windows of one axis: the order-fold sums of runs of `side` texels that begin at `first` and at the
/// texels behind it, weighted by a B-spline of that degree.
struct Windows {
    int side = 1;
    std::int64_t first = 0;
    std::array<double, 4> weights{};  ///< the first order + 1
};

/// The side of the box whose order-fold convolution has the variance of the steps, in whole texels.
int whole_side(double per_x, double per_y, int order) {
    const double side = std::floor(std::hypot(per_x, per_y) / std::sqrt(double(order)) + 0.5);
    return side < RepeatedAxis::longest_run ? std::max(1, int(side)) : RepeatedAxis::longest_run;
}

/// About a place of the axis. Runs, summed `order` times, spread order (side - 1) + 1 texels: their middle
/// lies half of that behind the first one's edge.
Windows windows_at(double place, int side, int order) {
    const double from = place_on_line(place) - 0.5 * (order * (side - 1) + 1);
    if (order == 2) {
        const double nearest = std::floor(from + 0.5), s = from - nearest;
        return {side,
                std::int64_t(nearest) - 1,
                {0.5 * (0.5 - s) * (0.5 - s), 0.75 - s * s, 0.5 * (0.5 + s) * (0.5 + s), 0}};
    }
    const double below = std::floor(from), f = from - below, g = 1 - f;
    return {side,
            std::int64_t(below) - 1,
            {g * g * g / 6, 2.0 / 3 - f * f * (2 - f) / 2, 2.0 / 3 - g * g * (2 - g) / 2, f * f * f / 6}};
}

template <int order>
struct RepeatedRule {
    RepeatedSums table;

    /// visit(column terms, row terms, weight) for every pair of windows.
    void each(const Footprint& f, auto&& visit) const {
        const Windows across = windows_at(f.centre.x, whole_side(f.per_x.x, f.per_y.x, order), order),
                      down = windows_at(f.centre.y, whole_side(f.per_x.y, f.per_y.y, order), order);
        const double texels = std::pow(across.side, order) * std::pow(down.side, order);
        std::array<std::vector<SumTerm>, order + 1> columns;
        for (std::size_t i = 0; i <= order; ++i)
            columns[i] = table.columns().runs(across.first + int(i), across.side);
        for (std::size_t j = 0; j <= order; ++j) {
            const std::vector<SumTerm> rows = table.rows().runs(down.first + int(j), down.side);
            for (std::size_t i = 0; i <= order; ++i)
                visit(columns[i], rows, across.weights[i] * down.weights[j] / texels);
        }
    }
    glm::dvec4 colour(const Footprint& footprint) const {
        glm::dvec4 colour{0};
        each(footprint, [&](const auto& columns, const auto& rows, double weight) {
            colour += weight * table.sum(columns, rows);
        });
        return colour;
    }
    std::vector<Tap> taps(const Footprint& footprint) const {
        std::vector<Tap> taps;
        each(footprint, [&](const auto& columns, const auto& rows, double weight) {
            for (const SumTerm& down : rows)
                for (const SumTerm& across : columns)
                    taps.push_back(
                        {0, across.index, down.index, weight * double(across.times) * double(down.times)});
        });
        return taps;
    }
};

template <int order>
Sampler prepare_repeated(const LinearImage& image, const FilterOptions& options) {
    const auto rule =
        std::make_shared<const RepeatedRule<order>>(RepeatedRule<order>{{image, options.addressing, order}});
    return {.colour = [rule](const Footprint& footprint) { return rule->colour(footprint); },
            .taps = [rule](const Footprint& footprint) { return rule->taps(footprint); },
            .stored = {rule->table.stored_image(image, options.addressing)}};
}

template <int order>
Method repeated(std::string name, const std::string& shape, const std::string& root) {
    return {
        .name = std::move(name),
        .card = {.footprint =
                     "A window along either axis: " + shape + " of w texels. w is hypot(du/dx, du/dy) / " +
                     root +
                     ", rounded half up to a whole number of 1 to 4096; along v the same. Without the "
                     "rounding it has the parallelogram's variance.",
                 .lod = "None: repeated sums of level 0.",
                 .taps = "The texels as squares, weighted by the window, from sums that are added up " +
                         std::to_string(order) + " times along either axis. At each of " +
                         std::to_string(order + 1) +
                         " ends, w apart, along either axis, they are interpolated between " +
                         std::to_string(order + 1) + " stored sums.",
                 .source = "Heckbert 1986, Filtering by repeated integration; the window's width is ours"},
        .prepare = prepare_repeated<order>};
}

}  // namespace

std::vector<Method> repeated_sat_methods() {
    return {repeated<2>("triangle-sat", "a triangle, the convolution of two boxes", "sqrt(2)"),
            repeated<3>("quadratic-sat", "a quadratic B-spline, the convolution of three boxes", "sqrt(3)")};
}

}  // namespace zproof::texture
