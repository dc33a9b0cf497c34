/// The oracles beside the reference: each is asked for its frame, and judged like everybody else.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/sampled_views.h"
#include "cli/view_result.h"
#include "renderers/registry.h"

namespace zproof {

/// An oracle that has been handed the scene, or why it has not.
struct OpenedOracle {
    OracleChoice choice;
    std::string absent;  ///< empty: renderer is there
    Renderer renderer;
    std::unique_ptr<SampledViews> samples{};  ///< null: it is asked about all pixels
};

/// Hands them the scene, and lets those that are asked about samples begin on these views.
std::vector<OpenedOracle> open_oracles(const std::vector<OracleChoice>& choices, const Scene& scene,
                                       const std::vector<View>& views);

/// What an oracle said, with its frame and what it was judged to be; none where it was not compared.
struct OracleAnswer {
    OracleResult result;
    std::unique_ptr<const Frame> frame{};
    Plane<PixelClass> classes{};           ///< of its frame
    std::optional<PixelLattice> pixels{};  ///< those of the frame; nothing: all of the view
};

/// Asks for the view, which stands at this place among those of open_oracles, and judges the answer against
/// the reference. A refusal is the answer's `absent`.
OracleAnswer ask_oracle(const OpenedOracle& oracle, const ViewContext& context, std::size_t place,
                        const RenderedFrame& reference);

/// Where candidate, reference and those that were compared name the same triangle, at the pixels that all of
/// them were asked about.
IdAgreement id_agreement_of(const Frame& candidate, const Frame& reference,
                            const std::vector<OracleAnswer>& answers);

/// Why the view cannot count as judged: an oracle that was required and not compared. Empty: it can.
std::string missing_oracle(const std::vector<OpenedOracle>& oracles,
                           const std::vector<OracleResult>& results);

}  // namespace zproof
