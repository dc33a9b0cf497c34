/// The oracles beside the reference: each is asked for its frame, and judged like everybody else.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/renderers/registry.h"
#include "cli/view_result.h"

namespace zproof {

/// An oracle that has been handed the scene, or why it has not.
struct OpenedOracle {
    OracleChoice choice;
    std::string absent;  ///< empty: renderer is there
    Renderer renderer;
};

std::vector<OpenedOracle> open_oracles(const std::vector<OracleChoice>& choices, const Scene& scene);

/// What an oracle said, with its frame and what it was judged to be; none where it was not compared.
struct OracleAnswer {
    OracleResult result;
    std::unique_ptr<const Frame> frame;
    Plane<PixelClass> classes;  ///< of its frame
};

/// Asks for the view and judges the answer against the reference. A refusal is the answer's `absent`.
OracleAnswer ask_oracle(const OpenedOracle& oracle, const ViewContext& context,
                        const RenderedFrame& reference);

/// Why the view cannot count as judged: an oracle that was required and not compared. Empty: it can.
std::string missing_oracle(const std::vector<OpenedOracle>& oracles,
                           const std::vector<OracleResult>& results);

}  // namespace zproof
