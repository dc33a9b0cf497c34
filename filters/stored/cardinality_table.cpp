#include "filters/stored/cardinality_table.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace zproof::texture {

namespace {

/// A box over the texels, in those of the finest level; as a filter its values integrate to 1.
struct Box {
    glm::dvec2 low, high;

    double area() const { return (high.x - low.x) * (high.y - low.y); }
};

/// The integral of the product of two box filters.
double dot(const Box& a, const Box& b) {
    const glm::dvec2 shared = glm::max(glm::min(a.high, b.high) - glm::max(a.low, b.low), 0.0);
    return shared.x * shared.y / (a.area() * b.area());
}

/// A texel of a level, counted from the first of the period.
struct Candidate {
    int level, column, row;

    Box box() const {
        const double size = 1 << level;
        return {size * glm::dvec2{column, row}, size * glm::dvec2{column + 1, row + 1}};
    }
};

/// Every texel of the three levels that the target reaches, the coarsest level first, row by row.
std::vector<Candidate> candidates(const Box& target) {
    std::vector<Candidate> all;
    for (int level = CardinalityTable::levels - 1; level >= 0; --level) {
        const double size = 1 << level;
        const glm::ivec2 first{glm::floor(target.low / size)}, end{glm::ceil(target.high / size)};
        for (int row = first.y; row < end.y; ++row)
            for (int column = first.x; column < end.x; ++column) all.push_back({level, column, row});
    }
    return all;
}

using Matrix = std::vector<std::vector<double>>;

/// The inverse of a symmetric positive definite matrix, by elimination.
Matrix inverse(Matrix a) {
    const std::size_t n = a.size();
    Matrix b(n, std::vector<double>(n));
    for (std::size_t i = 0; i < n; ++i) b[i][i] = 1;
    for (std::size_t k = 0; k < n; ++k) {
        const double pivot = a[k][k];
        for (std::size_t j = 0; j < n; ++j) a[k][j] /= pivot, b[k][j] /= pivot;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double times = a[i][k];
            for (std::size_t j = 0; j < n; ++j) a[i][j] -= times * a[k][j], b[i][j] -= times * b[k][j];
        }
    }
    return b;
}

double sum(const std::vector<double>& line) {
    double all = 0;
    for (const double value : line) all += value;
    return all;
}

/// Which of n values is the least; of those within `alike` of it the first.
template <class F>
std::size_t least_of(std::size_t n, double alike, F&& f) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(f(i));
    const double least = *std::ranges::min_element(values);
    return std::size_t(std::ranges::find_if(values, [&](double v) { return v <= least + alike; }) -
                       values.begin());
}

/// Texels that shall stand for a target, by weights of sum 1. With e_i the filter of texel i less the target,
/// the square error is |sum w_i e_i|^2; a millionth of the target's square for each |w|^2 makes of it w E w
/// with a definite E.
struct Problem {
    double little;  ///< that millionth: errors that differ by no more are alike
    Matrix products;

    Problem(const Box& target, const std::vector<Candidate>& all) : little{0x1p-20 * dot(target, target)} {
        for (const Candidate& a : all) {
            products.emplace_back();
            for (const Candidate& b : all)
                products.back().push_back(dot(a.box(), b.box()) - dot(a.box(), target) -
                                          dot(b.box(), target) + dot(target, target) +
                                          (&a == &b ? little : 0));
        }
    }
};

/// Some of the texels and their weights, by least squares: in proportion to E^-1 1, with an error of 1 / (1
/// E^-1 1).
class Fit {
  public:
    explicit Fit(const Problem& problem) : problem_{&problem} {}

    const std::vector<std::size_t>& chosen() const { return chosen_; }
    std::vector<double> weights() const {
        std::vector<double> all;
        for (const std::vector<double>& line : inverse_) all.push_back(sum(line) / total_);
        return all;
    }
    double error() const { return 1 / total_; }
    bool is_better_than(const Fit& other) const { return error() < other.error() - problem_->little; }

    /// With the one texel more with which the error is least.
    Fit with_another() const {
        const std::size_t next = least_of(problem_->products.size(), problem_->little,
                                          [&](std::size_t i) { return error_with(i); });
        Fit fit = *this;
        fit.chosen_.push_back(next);
        fit.update();
        return fit;
    }
    Fit without(std::size_t i) const {
        Fit fit = *this;
        fit.chosen_.erase(fit.chosen_.begin() + std::ptrdiff_t(i));
        fit.update();
        return fit;
    }
    /// Without the texel that is missed least.
    Fit with_one_fewer() const {
        return without(least_of(chosen_.size(), problem_->little, [&](std::size_t i) {
            const double own = sum(inverse_[i]);
            return 1 / (total_ - own * own / inverse_[i][i]);
        }));
    }
    /// With one texel in another's place.
    Fit with_an_exchange() const {
        const auto exchanged = [&](std::size_t i) { return without(i).with_another(); };
        return exchanged(
            least_of(chosen_.size(), problem_->little, [&](std::size_t i) { return exchanged(i).error(); }));
    }

  private:
    /// By bordering the inverse. Of a texel that is chosen already the border is nothing.
    double error_with(std::size_t next) const {
        const Matrix& products = problem_->products;
        double left = products[next][next], one = 1;
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            if (chosen_[i] == next) return error();
            double along = 0;
            for (std::size_t j = 0; j < chosen_.size(); ++j)
                along += inverse_[i][j] * products[chosen_[j]][next];
            left -= along * products[chosen_[i]][next];
            one -= along;
        }
        return 1 / (total_ + one * one / left);
    }
    void update() {
        Matrix own;
        for (const std::size_t i : chosen_) {
            own.emplace_back();
            for (const std::size_t j : chosen_) own.back().push_back(problem_->products[i][j]);
        }
        inverse_ = inverse(own);
        total_ = 0;
        for (const std::vector<double>& line : inverse_) total_ += sum(line);
    }

    const Problem* problem_;
    std::vector<std::size_t> chosen_;
    Matrix inverse_;    ///< of the chosen ones' products
    double total_ = 0;  ///< of its elements
};

/// Texels are added, one by one, as long as each lowers the error. Then any that is not missed goes, and any
/// is exchanged for a better one, until that changes nothing.
Fit best_fit(const Problem& problem, std::size_t texels) {
    Fit fit{problem};
    for (;;) {
        if (fit.chosen().size() < texels)
            if (const Fit more = fit.with_another(); more.is_better_than(fit)) {
                fit = more;
                continue;
            }
        if (fit.chosen().size() < 2) return fit;
        if (const Fit fewer = fit.with_one_fewer(); !fit.is_better_than(fewer)) {
            fit = fewer;
            continue;
        }
        const Fit other = fit.with_an_exchange();
        if (!other.is_better_than(fit)) return fit;
        fit = other;
    }
}

/// 2^(lod / 8), by roots, which are the same everywhere.
double pixel_side(int lod) {
    static_assert(CardinalityTable::steps == 8);
    double side = std::ldexp(1.0, lod / CardinalityTable::steps);
    for (int bit = 4, root = 1; bit > 0; bit /= 2, ++root) {
        double power = 2;
        for (int i = 0; i < root; ++i) power = std::sqrt(power);
        if ((lod & bit) != 0) side *= power;
    }
    return side;
}

std::vector<TableTap> entry(const glm::ivec2& at, int lod, int texels) {
    const glm::dvec2 place = glm::dvec2{at} / double(CardinalityTable::steps), half{pixel_side(lod) / 2};
    const Box target{place - half, place + half};
    const std::vector<Candidate> all = candidates(target);
    const Problem problem{target, all};
    const Fit fit = best_fit(problem, std::size_t(texels));
    std::vector<TableTap> taps;
    const std::vector<double> weights = fit.weights();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Candidate& c = all[fit.chosen()[i]];
        const glm::ivec2 holding{place / double(1 << c.level)};
        taps.push_back({c.level, c.column - holding.x, c.row - holding.y, weights[i]});
    }
    return taps;
}

}  // namespace

CardinalityTable::CardinalityTable(int texels) {
    for (int lod = 0; lod < lods; ++lod)
        for (int v = 0; v < places; ++v)
            for (int u = 0; u < places; ++u) {
                const std::vector<TableTap> taps = entry({u, v}, lod, texels);
                taps_.insert(taps_.end(), taps.begin(), taps.end());
                begin_.push_back(taps_.size());
            }
}

}  // namespace zproof::texture
