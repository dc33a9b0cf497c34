#include "compare/diagnosis/hypotheses/moved_part.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace zproof {

const Part* only_part_that_differs(const DiagnosisInput& input) {
    const auto part_of = [&](PrimitiveId id) -> const Part* {
        const auto next =
            std::ranges::upper_bound(input.scene.parts, std::uint32_t(id), {}, &Part::first_triangle);
        if (next == input.scene.parts.begin()) return nullptr;
        const Part& part = *std::prev(next);
        return std::uint32_t(id) - part.first_triangle < part.triangle_count ? &part : nullptr;
    };
    const auto ours = input.candidate.frame.primitive.pixels(),
               theirs = input.reference.frame.primitive.pixels();
    std::optional<std::array<const Part*, 2>> either;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        if (ours[i] == theirs[i]) continue;
        const std::array here{part_of(ours[i]), part_of(theirs[i])};
        if (!either) either = here;
        for (const Part*& one : *either)
            if (one != here[0] && one != here[1]) one = nullptr;
        if (!(*either)[0] && !(*either)[1]) return nullptr;
    }
    if (!either || input.said || input.scene.parts.size() < 2) return nullptr;
    return (*either)[0] ? (*either)[0] : (*either)[1];
}

std::shared_ptr<const Scene> with_part_moved(const Scene& scene, const Part& part, const Camera& declared,
                                             const Camera& fitted) {
    const auto moved = std::make_shared<Scene>();
    moved->vertices.position_world = scene.vertices.position_world;
    moved->triangles = scene.triangles;
    auto& positions = moved->vertices.position_world;
    for (std::uint32_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const glm::dvec3 from_eye =
                glm::dvec3(positions[scene.triangles[t][corner]]) - glm::dvec3(fitted.eye_world);
            moved->triangles[t][corner] = std::uint32_t(positions.size());
            positions.push_back(glm::vec3(
                glm::dvec3(declared.eye_world) + dot(fitted.right, from_eye) * declared.right +
                dot(fitted.up, from_eye) * declared.up + dot(fitted.back, from_eye) * declared.back));
        }
    return moved;
}

}  // namespace zproof
