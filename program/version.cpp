#include "program/version.h"

#include <cstdlib>
#include <ctime>
#include <fstream>

#include "oracle/embree.h"

namespace zproof {

std::string version_number() { return ZPROOF_VERSION; }

std::string compiler_name() {
#ifdef __clang__
    return std::string{"clang++ "} + __clang_version__;
#else
    return std::string{"g++ "} + __VERSION__;
#endif
}

std::string processor_name() {
    std::ifstream file{"/proc/cpuinfo"};
    for (std::string line; std::getline(file, line);)
        if (const std::size_t colon = line.find(": ");
            line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    return "unknown";
}

std::string utc_now() {
    const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t moment =
        fixed != nullptr ? std::time_t(std::strtoll(fixed, nullptr, 10)) : std::time(nullptr);
    std::tm parts{};
    gmtime_r(&moment, &parts);
    std::string text(sizeof "2026-11-26T18:09:00Z", '\0');
    text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts));
    return text;
}

std::string version_line() {
    return "zproof " + version_number() + " (commit " + commit() + "; " + compiler_name() + "; " +
           oracle::embree_version() + ")";
}

}  // namespace zproof
