/// The witnesses beside the reference: each is asked for its frame, and judged like everybody else.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/renderers/roster.h"
#include "cli/view_result.h"

namespace zproof {

/// A witness that has been handed the scene, or why it has not.
struct SummonedWitness {
    WitnessChoice choice;
    std::string absent;  ///< empty: renderer is there
    Renderer renderer;
};

std::vector<SummonedWitness> summon(const std::vector<WitnessChoice>& choices, const Scene& scene);

/// What a witness said, with its frame and what it was judged to be; none where it was not heard.
struct Statement {
    WitnessResult result;
    std::unique_ptr<const Frame> frame;
    Plane<PixelClass> classes;  ///< of its frame
};

/// Asks for the view and judges the answer against the reference. A refusal is the statement's `absent`.
Statement hear(const SummonedWitness& witness, const Docket& docket, const RenderedFrame& reference);

/// Why the view cannot count as judged: a witness that was required and not heard. Empty: it can.
std::string missing_witness(const std::vector<SummonedWitness>& witnesses,
                            const std::vector<WitnessResult>& results);

}  // namespace zproof
