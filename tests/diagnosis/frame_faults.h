/// Faults put into a good frame, each with the name that the diagnosis must give it.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "scenes/loaded.h"

namespace zproof {

struct FrameFault {
    std::string name;   ///< letters, digits and '_'
    std::string cause;  ///< as compare/diagnosis/hypotheses/ calls it; empty: none is certain
    std::function<Frame(const Scene&, const View&, const Frame& good)> inject;
    std::string scene = "room";  ///< of the suite
};

/// Names the fault in the test's parameter line; found by gtest in this namespace.
inline void PrintTo(const FrameFault& fault, std::ostream* out) {
    *out << fault.name << " in " << fault.scene;
}

const std::vector<FrameFault>& frame_faults();

}  // namespace zproof
