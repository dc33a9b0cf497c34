/// Reports of a run for other programs: results.csv, junit.xml, summary.md, and lines for GitHub Actions.
#pragma once

#include <cstddef>
#include <string>

#include "reports/results.h"
#include "reports/text_sink.h"

namespace zproof {

/// GitHub takes a step's summary of up to 1 MiB and drops a larger one whole; the rest is for other steps.
inline constexpr std::size_t largest_summary = 1'000'000;

/// Verdict in a sentence, a table of the views (failed first), the story of those that fail, and what the
/// waivers did. Text only: names are escaped, so that a scene can neither write markup nor break the table.
/// Never larger than largest_summary bytes, of which the table takes what stories and waivers leave, at least
/// half; what was left out is said.
std::string to_markdown(const Results& results);

/// Jenkins' dialect: a suite per reference renderer, a case per view. A defect is a <failure> whose type is
/// the class of the worst pixel; a view that judged nothing is a <failure> as well, never <skipped>; an
/// unreadable input is an <error>. Waived pixels fail nothing; the case says how many there are and by which
/// waiver. Cases with evidence name class.png in the attachment notation of Jenkins
/// and GitLab.
void write_junit(const TextSink& out, const Results& results);
std::string to_junit(const Results& results);  ///< the same, in memory

/// A row per view and class, RFC 4180 with lines ended by a newline alone; a view that was not judged has one
/// row without class. Columns: scene, view, source, scene_sha256, candidate, reference, width, height,
/// triangles, outcome, class, gate (passes or fails), pixels, waived, message.
void write_csv(const TextSink& out, const Results& results);
std::string to_csv(const Results& results);  ///< the same, in memory

/// GitHub shows so many errors and so many warnings of a step, and drops the rest without a word.
inline constexpr std::size_t most_annotations = 10;

/// "::error file=...,line=1,title=...::message" for expired waivers and every view that fails, the worst
/// first; "::warning ..." for other waivers that need a hand. Of each kind at most most_annotations, then a
/// plain line that counts the rest. Empty where there is nothing to say.
std::string to_github(const Results& results);

/// The text as GitHub wants it in a message, and in a property ("title"): % \r \n, and in properties : and ,
/// are percent-encoded.
std::string github_message(const std::string& text);
std::string github_property(const std::string& text);

}  // namespace zproof
