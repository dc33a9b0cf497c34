#pragma once

#include <stdexcept>

namespace zproof {

/// A command line that cannot be understood: says which word, and what was expected in its place.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace zproof
