/// Who is speaking: for --version and for results.json.
#pragma once

#include <string>

namespace zproof {

std::string version_number();  ///< "0.2.0"
std::string commit();          ///< "22ec5f20a1b2", with ", changed" behind it, or "unknown"
std::string compiler_name();   ///< "g++ 12.2.0"
std::string processor_name();  ///< "AMD EPYC-Milan Processor", or "unknown"
std::string utc_now();         ///< "2026-11-26T18:09:00Z"; the moment of SOURCE_DATE_EPOCH where that is set
std::string version_line();    ///< all of these, and the reference's version

}  // namespace zproof
