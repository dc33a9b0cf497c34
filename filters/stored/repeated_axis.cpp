#include "filters/stored/repeated_axis.h"

#include <algorithm>
#include <array>

namespace zproof::texture {

namespace {

/// C(n, k) for any whole n: n (n - 1) ... (n - k + 1) / k!.
std::int64_t binomial(std::int64_t n, int k) {
    std::int64_t product = 1;
    for (int i = 0; i < k; ++i) product = product * (n - i) / (i + 1);
    return product;
}

std::int64_t alternating(int i) { return i % 2 == 0 ? 1 : -1; }

/// Each index once, in order; without those that cancel.
std::vector<SumTerm> collected(std::vector<SumTerm> terms) {
    std::ranges::sort(terms, {}, &SumTerm::index);
    std::vector<SumTerm> each;
    for (const SumTerm& term : terms) {
        if (each.empty() || each.back().index != term.index) each.push_back({term.index, 0});
        each.back().times += term.times;
    }
    std::erase_if(each, [](const SumTerm& term) { return term.times == 0; });
    return each;
}

}  // namespace

std::vector<SumTerm> RepeatedAxis::runs(std::int64_t first, int side) const {
    const std::int64_t near = moved_near(first, side);
    Terms terms;
    for (int i = 0; i <= order_; ++i) {
        const std::int64_t k = near + std::int64_t{i} * side,
                           times = alternating(order_ - i) * binomial(order_, i);
        if (wrap_ == Wrap::clamp_to_edge)
            add_clamped(terms, k, times);
        else
            add_repeated(terms, k, times);
    }
    return collected(std::move(terms));
}

/// Into the first period; of a clamped axis, no farther from it than where all is the edge's texel.
std::int64_t RepeatedAxis::moved_near(std::int64_t first, int side) const {
    if (wrap_ == Wrap::clamp_to_edge)
        return std::clamp(first, -std::int64_t{order_} * side, std::int64_t{size_});
    const std::int64_t period = stored();
    return (first % period + period) % period;
}

/// Q_order(k), 0 <= k < stored() + order: entry k - order, which is 0 before the first.
void RepeatedAxis::add_stored(Terms& terms, std::int64_t k, std::int64_t times) const {
    if (k >= order_) terms.push_back({int(k - order_), times});
}

/// Q of a lower order, 0 the texel itself, as differences of the one that is stored.
void RepeatedAxis::add_lower(Terms& terms, int order, std::int64_t k, std::int64_t times) const {
    const int differences = order_ - order;
    for (int i = 0; i <= differences; ++i)
        add_stored(terms, k + i, times * alternating(differences - i) * binomial(differences, i));
}

/// k >= 0. With s_j = Q_j at the end of a number of whole periods, T_j = Q_j of one: over another period s_j
/// gains T_j + sum of C(period, i) s_(j-i), i = 1 to j - 1; over y texels more Q_n gains Q_n(y) + sum of C(y,
/// i) s_(n-i).
void RepeatedAxis::add_repeated(Terms& terms, std::int64_t k, std::int64_t times) const {
    const std::int64_t period = stored(), periods = k / period, rest = k % period;
    using OfOnePeriod = std::array<std::int64_t, 4>;  // how often each T_j counts
    std::array<OfOnePeriod, 4> s{};                   // by j
    for (std::int64_t p = 0; p < periods; ++p)
        for (int j = order_; j >= 1; --j) {
            for (int i = 1; i < j; ++i)
                for (std::size_t t = 1; t < 4; ++t)
                    s[std::size_t(j)][t] += binomial(period, i) * s[std::size_t(j - i)][t];
            ++s[std::size_t(j)][std::size_t(j)];
        }
    add_stored(terms, rest, times);
    for (int t = 1; t <= order_; ++t) {
        std::int64_t count = 0;
        for (int i = 0; i < order_; ++i)
            count += binomial(rest, i) * s[std::size_t(order_ - i)][std::size_t(t)];
        if (count != 0) add_lower(terms, t, period, times * count);
    }
}

/// Before the axis all texels are the first, behind it the last: Q_n(-y) = C(-y, n) t_0, and Q_n(size + y) =
/// sum of C(y, i) Q_(n-i)(size), with C(y, n) of the last texel.
void RepeatedAxis::add_clamped(Terms& terms, std::int64_t k, std::int64_t times) const {
    if (k <= 0) return add_stored(terms, order_, times * binomial(k, order_));
    if (k < size_) return add_stored(terms, k, times);
    for (int i = 0; i < order_; ++i) add_lower(terms, order_ - i, size_, times * binomial(k - size_, i));
    add_lower(terms, 0, size_ - 1, times * binomial(k - size_, order_));
}

}  // namespace zproof::texture
