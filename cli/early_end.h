/// A run that ends before all is judged, because of what it has seen so far.
#pragma once

#include <string>

#include "cli/arguments.h"
#include "reports/results.h"

namespace zproof {

class EarlyEnd {
  public:
    explicit EarlyEnd(const EarlyEndRule& rule) : rule_(rule) {}

    /// What came of a view, in the order of the run. To be called again where its outcome became a worse one.
    void note(const ViewResult& view);

    bool has_seen_a_failure() const { return failed_ > 0; }
    bool is_due() const { return !why_.empty(); }
    const std::string& why() const { return why_; }  ///< what is said of each view that is left

  private:
    EarlyEndRule rule_;
    int failed_ = 0;
    bool has_an_answer_ = false;  ///< a view was judged
    int same_words_ = 0;          ///< views that were refused in `words_`, one after the other
    std::string words_, why_;
};

}  // namespace zproof
