/// The length of a description of a frame: how a hypothesis is scored (docs/diagnosis.md, "The score").
#pragma once

#include <cmath>
#include <cstddef>

#include "compare/diagnosis/hypothesis.h"

namespace zproof {

/// log2 of the ways to choose some of many: what it takes to tell which they are.
inline double bits_of_choice(double some, double all) {
    if (some <= 0 || some >= all) return 0;
    const double share = some / all;
    return -all * (share * std::log2(share) + (1 - share) * std::log2(1 - share));
}

/// What is told of a frame of that size, by one of so many hypotheses.
class Description {
  public:
    Description(const DiagnosisInput& input, std::size_t hypotheses)
        : bits_of_answer_(bits_of_an_id(input) + 32),
          pixels_(double(input.candidate.frame.size().pixel_count())),
          bits_of_name_(std::log2(double(hypotheses))) {}

    /// Bits that say which pixels they are whose answers nothing predicts, and what they answer.
    double of_exceptions(double count) const {
        return bits_of_choice(count, pixels_) + count * bits_of_answer_;
    }
    double of_name() const { return bits_of_name_; }

  private:
    double bits_of_answer_, pixels_, bits_of_name_;
};

}  // namespace zproof
