#include "cli/version.h"

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

std::string version_line() {
    return "zproof " + version_number() + " (commit " + commit() + "; " + compiler_name() + "; " +
           oracle::embree_version() + ")";
}

}  // namespace zproof
