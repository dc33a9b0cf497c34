/// junit.xml, for the test pages of CI servers.
#pragma once

#include <string>

#include "reports/results.h"
#include "reports/text_sink.h"

namespace zproof {

/// Jenkins' dialect: a suite per reference renderer, a case per view. A defect is a <failure> whose type is
/// the class of the worst pixel; a view that judged nothing is a <failure> as well, never <skipped>; an
/// unreadable input is an <error>. Waived pixels fail nothing; the case says how many there are and by which
/// waiver. Cases with evidence name class.png in the attachment notation of Jenkins
/// and GitLab.
void write_junit(const TextSink& out, const Results& results);
std::string to_junit(const Results& results);  ///< the same, in memory

}  // namespace zproof
