#pragma once

#include <stdexcept>

namespace zproof {

/// A reference could not be asked: names the reference and what it said.
struct OracleError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace zproof
