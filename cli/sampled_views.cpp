#include "cli/sampled_views.h"

#include <algorithm>
#include <utility>

#include "oracle/oracle_error.h"

namespace zproof {
namespace {

/// At work at a time, beside those that are waited for. A program that draws a small picture mostly starts
/// and ends.
constexpr std::size_t most_ahead = 4;

}  // namespace

SampledViews::SampledViews(const Renderer& renderer, std::vector<View> views)
    : begin_sample_(renderer.begin_sample), views_(std::move(views)) {
    begin_up_to(most_ahead);
}

SampledFrame SampledViews::take(std::size_t place) {
    while (first_ < place && !begun_.empty()) begun_.pop_front(), ++first_;
    begin_up_to(place + 1);
    const std::function<SampledFrame()> answer = std::move(begun_.front());
    begun_.pop_front();
    ++first_;
    begin_up_to(first_ + most_ahead);
    return answer();
}

void SampledViews::begin_up_to(std::size_t end) {
    for (std::size_t i = first_ + begun_.size(); i < std::min(end, views_.size()); ++i) try {
            const BegunSample begun = begin_sample_(views_[i], seed);
            begun_.push_back([begun] {
                return SampledFrame{begun.pixels, begun.fewer_because, begun.frame()};
            });
        } catch (const OracleError& e) {
            begun_.push_back([e]() -> SampledFrame { throw e; });
        }
}

}  // namespace zproof
