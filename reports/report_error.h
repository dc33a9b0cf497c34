#pragma once

#include <stdexcept>

namespace zproof {

/// A report could not be written or read: names the path or place and the reason.
struct ReportError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace zproof
