/// The one place that knows how the judge is called.
#pragma once

#include "compare/judge.h"
#include "tests/frozen/subject.h"

namespace zproof::frozen {

/// With the findings of all pixels that fail, others may be among them. Throws std::invalid_argument where
/// the frames are none of the view's.
inline Verdict judged(const Case& c) {
    return judge(*c.scene, c.view, {c.candidate, c.candidate_precision}, {c.reference, c.reference_precision},
                 full_detail);
}

}  // namespace zproof::frozen
