/// What commands that render have in common.
#pragma once

#include <string>
#include <vector>

#include "frame/plane.h"
#include "scenes/sample.h"

namespace zproof {

enum class ProgressStyle {
    automatic,  ///< a bar on a terminal, lines elsewhere
    bar,        ///< one line that is redrawn
    lines,      ///< a line per judged view
    none,       ///< remarks only
    silent,     ///< -q: not even remarks
};

/// The resolution at which the suite's expectations hold.
inline constexpr Resolution default_resolution{.width = 1920, .height = 1080};

/// Threads that the machine offers, 1 to 1024.
int available_threads();

/// How views are made; shared by every command that renders.
struct RenderSettings {
    Resolution resolution =
        default_resolution;                 ///< of suite scenes and glTF files; a view file states its own
    std::vector<Sample> samples{Sample{}};  ///< of every view
    std::string sample_word{};              ///< that they were typed with; empty: the centre
};

}  // namespace zproof
