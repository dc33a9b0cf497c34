/// What is wrong with a whole run: the causes of its failed views, the weightiest first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

struct RunCause {
    std::string name;     ///< as the views' diagnoses name it: "the image is flipped in y"
    std::string look_at;  ///< where in a renderer's code to look first, a sentence; may be empty
    std::string fitted;   ///< the number that all of its views fit; empty where they differ
    std::uint64_t views = 0;
    double saved_bits = 0, all_bits = 0;  ///< over its views: what it spares, of what the defects take
};

/// The views of a run vote for their likely causes, one after the other.
class CauseVote {
  public:
    void note(const ViewResult& view);  ///< One that is not defective, or has no cause, does not vote.
    const std::vector<RunCause>& causes() const { return causes_; }  ///< in the order in which they came
    std::vector<EarlierCause> earlier() const;                       ///< for the views that follow

  private:
    std::vector<RunCause> causes_;
};

/// By the bits that they spare in the views of which each is the likely cause, then by the number of these
/// views; of equals, the one that was named first.
std::vector<RunCause> run_causes(const Results& results);

/// The views that are defective: waived ones are not.
std::uint64_t failed_views(const Results& results);

/// "Likely cause of 5 of 7 failed views: A. Look at ...", or "of all 7"; says so where no view has one, and
/// where none was sought. Empty where no view fails.
std::string cause_in_words(const Results& results);

}  // namespace zproof
