#pragma once

#include <stdexcept>

namespace zproof {

/// A scene or view file that cannot be used. The message names the file, the place in it, what was expected
/// and, where there is one, the remedy; it is one line.
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace zproof
