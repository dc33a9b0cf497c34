#include "cli/labelled_candidate.h"

#include <utility>

namespace zproof {

std::string CandidateFrame::label_sentence(int x, int y) const {
    const bool names_label = labels && frame.primitive.at(x, y) != PrimitiveId::none;
    return names_label ? zproof::label_sentence(*labels, own_ids.at(x, y)) : "";
}

std::optional<SaidLabels> CandidateFrame::said() const {
    return labels ? std::optional(SaidLabels{*labels, own_ids}) : std::nullopt;
}

CandidateFrame candidate_frame(const Scene& scene, const View& view, const Renderer& renderer, Frame given,
                               const RenderedFrame& reference) {
    if (!renderer.labels) return {.frame = std::move(given), .labels = nullptr, .own_ids = {}};
    given.attributes = {};  // they are of triangles that the frame does not name
    Frame frame = with_triangles(scene, view, {given, renderer.precision}, *renderer.labels, reference);
    return {std::move(frame), renderer.labels, std::move(given.primitive)};
}

}  // namespace zproof
