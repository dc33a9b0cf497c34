/// What many textures say together: means of methods with their confidence, ranks, and paired differences.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "filters/study/results.h"

namespace zproof::study {

/// Ends of a 95 % interval.
struct Spread {
    double low = 0, high = 0;
};

/// A method over all textures. A texture's value is the mean of a metric over its views.
struct PooledMethod {
    std::string label;
    double mean = 0;
    Spread mean_spread;
    int rank = 0;            ///< by the mean; 1 is the best
    Spread rank_spread;      ///< percentiles of the ranks that it has in the samples
    double first_share = 0;  ///< of the samples in which it is the best
    double difference = 0;   ///< mean of what it has more than the baseline, texture by texture
    Spread difference_spread;
};

struct PoolChoice {
    std::string metric = "psnr", region = "interior";
    std::string baseline{};  ///< a method's label; empty: the best one
    int samples = 10'000;
    std::uint32_t seed = 1;
};

struct PooledScores {
    PoolChoice choice;  ///< with the baseline that was taken
    std::size_t textures = 0, views = 0;
    std::vector<PooledMethod> methods;  ///< the best first
    std::vector<std::string> left_out;  ///< methods that lack a number in a view in which others have one
    std::vector<std::string>
        textures_left_out;  ///< on which a method is without error, and its PSNR infinite
};

/// Inputs of the study.
std::size_t texture_count(const StudyResults& results);

/// The 95 % interval of a mean from independent values: Student's t, its skewness removed by Hall's cubic
/// transformation (Hall 1992, Journal of the Royal Statistical Society B 54(1)). Not numbers where there is
/// one value.
Spread interval_of_mean(std::span<const double> values);

/// Intervals of means and differences are interval_of_mean() over the study's inputs, one texture each. For
/// ranks the inputs are drawn `samples` times with replacement, for all methods alike (Efron 1979, Annals of
/// Statistics 7(1)). They say how far the result depends on the choice of textures, not of views: views of
/// one texture are never taken apart. The same bits every time. `metric` must be one of
/// StudyResults::metrics; the baseline, a method of the pool.
PooledScores pooled(const StudyResults& results, const PoolChoice& choice);

}  // namespace zproof::study
