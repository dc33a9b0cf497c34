#include <algorithm>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/renamed_ids.h"

namespace zproof {

namespace {

/// Index of the triangle's node among all nodes that the scene has parts of, in order of the parts.
std::vector<std::uint32_t> nodes_of_parts(const Scene& scene) {
    std::vector<std::uint32_t> nodes;
    for (std::size_t part = 0; part < scene.parts.size(); ++part) {
        const bool is_new = part > 0 && (scene.parts[part].node_index != scene.parts[part - 1].node_index ||
                                         scene.parts[part].node != scene.parts[part - 1].node);
        nodes.push_back(part == 0 ? 0 : nodes.back() + (is_new ? 1 : 0));
    }
    return nodes;
}

std::vector<Hypothesis> of_groups(const DiagnosisInput& input) {
    const Scene& scene = input.scene;
    std::vector<Hypothesis> all{
        with_ids_reported_as(
            input,
            {"the id is the quad's, of two triangles each", "An id is the triangle's index divided by 2.",
             "Look at the mesh's faces: the id counts quads; count triangles."},
            [](std::uint32_t id) { return id / 2; }),
        with_ids_reported_as(input,
                             {"both triangles of a quad have the first's id",
                              "Of two triangles in a row, both bear the even one's id.",
                              "Look at the mesh's faces: both halves of a quad were given one id."},
                             [](std::uint32_t id) { return id & ~1u; })};
    if (scene.parts.size() < 2) return all;
    all.push_back(with_ids_reported_as(
        input,
        {"the id is the material's", "An id is the index of the triangle's material.",
         "Look at what the id buffer is given: the material's index, not the triangle's."},
        [&scene](std::uint32_t id) { return std::uint32_t(scene.parts[part_of(scene, id)].material); }));
    const std::vector<std::uint32_t> nodes = nodes_of_parts(scene);
    if (nodes.back() + 1 < scene.parts.size())
        all.push_back(with_ids_reported_as(
            input,
            {"the id is the node's", "An id is the index of the triangle's node among those drawn.",
             "Look at what the id buffer is given: the object's index, not the triangle's."},
            [nodes, &scene](std::uint32_t id) { return nodes[part_of(scene, id)]; }));
    return all;
}

std::vector<Hypothesis> clamped(const DiagnosisInput& input) {
    std::vector<Hypothesis> all;
    for (const std::uint32_t most : {0xFFu, 0xFFFFu})
        if (most + 1 < input.scene.triangles.size())
            all.push_back(with_ids_reported_as(
                input,
                {"ids end at " + std::to_string(most), "A larger id is told as " + std::to_string(most) + ".",
                 "Look at the id buffer's format: ids are clamped where they should be kept whole."},
                [most](std::uint32_t id) { return std::min(id, most); }));
    return all;
}

/// The one id of all triangles that the candidate shows, if there is one.
std::optional<std::uint32_t> only_id(const Frame& frame) {
    std::optional<std::uint32_t> only;
    for (const PrimitiveId id : frame.primitive.pixels()) {
        if (id == PrimitiveId::none) continue;
        if (only && *only != std::uint32_t(id)) return std::nullopt;
        only = std::uint32_t(id);
    }
    return only;
}

std::vector<Hypothesis> one_for_all(const DiagnosisInput& input) {
    if (input.scene.triangles.size() < 2) return {};
    const char* not_written = "Look at whether the id is written at all: a default value stays.";
    std::vector<Hypothesis> all{with_ids_reported_as(
        input, {"all triangles have the id 0", "An id is 0, whichever triangle it stands for.", not_written},
        [](std::uint32_t) { return 0u; })};
    const std::optional<std::uint32_t> only = only_id(input.candidate.frame);
    if (!only || *only == 0) return all;
    Hypothesis h = with_ids_reported_as(
        input,
        {"all triangles have one id",
         "An id is " + std::to_string(*only) + ", whichever triangle it stands for.", not_written},
        [only](std::uint32_t) { return *only; });
    h.learned_bits = bits_of_an_id(input);
    all.push_back(std::move(h));
    return all;
}

Hypothesis shared(const DiagnosisInput& input) {
    const Ids ours =
        most_often_with(input.reference.frame.primitive.pixels(), input.candidate.frame.primitive.pixels());
    const auto told = [ours](std::uint32_t id) {
        const auto found = ours.find(id);
        return found == ours.end() ? id : found->second;
    };
    Hypothesis h = with_ids_reported_as(
        input,
        {"several triangles have one id",
         "An id stands for more triangles than one, the same wherever they occur.",
         "Look at what the id stands for: a face, an object or a cluster instead of the triangle."},
        told);
    h.learned_bits = 2 * double(ours.size()) * bits_of_an_id(input);
    return h;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_shared_ids(const DiagnosisInput& input) {
    std::vector<Hypothesis> all = one_for_all(input);
    for (const auto& more : {of_groups(input), clamped(input)})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(shared(input));
    return all;
}

}  // namespace zproof
