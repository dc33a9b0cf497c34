/// Ids that stand for something else than the triangle's index.
#include <algorithm>

#include "tests/reports_from_the_field/field_frames.h"
#include "tests/reports_from_the_field/field_scenes.h"
#include "tests/reports_from_the_field/ray_caster.h"

namespace zproof::field {

namespace {

using Told = std::function<std::uint32_t(const Scene&, std::uint32_t id)>;

std::function<Shown()> telling(const Scene& scene, const View& view, const Told& told,
                               PrimitiveId background = PrimitiveId::none) {
    return [=] {
        Frame frame = cast(scene, view);
        for (PrimitiveId& id : frame.primitive.pixels())
            id = id == PrimitiveId::none ? background : PrimitiveId(told(scene, std::uint32_t(id)));
        return Shown{scene, view, frame};
    };
}

std::uint32_t part_of(const Scene& scene, std::uint32_t id) {
    std::uint32_t part = 0;
    while (id >= scene.parts[part].first_triangle + scene.parts[part].triangle_count) ++part;
    return part;
}

/// Part by part, the last first.
std::uint32_t with_parts_reversed(const Scene& scene, std::uint32_t id) {
    const std::uint32_t part = part_of(scene, id);
    std::uint32_t before = 0;
    for (std::size_t k = part + 1; k < scene.parts.size(); ++k) before += scene.parts[k].triangle_count;
    return before + id - scene.parts[part].first_triangle;
}

}  // namespace

std::vector<FieldFrame> frames_of_ids() {
    const Scene scene = yard(), many = hills(20);
    const View view = view_of_yard();
    return {
        {"ids_from_one",
         {"ids count from 1, and 0 is background"},
         "nvdiffrast #137: the value is offset by one, and 0 means that there is no triangle",
         telling(
             scene, view, [](const Scene&, std::uint32_t id) { return id + 1; }, PrimitiveId(0))},
        {"every_id_0",
         {"all triangles have the id 0"},
         "pbrt-v3 #284: faceIndex is 0 at every pixel",
         telling(scene, view, [](const Scene&, std::uint32_t) { return 0u; })},
        {"every_id_7",
         {"all triangles have one id"},
         "zproof #43: one id for all",
         telling(scene, view, [](const Scene&, std::uint32_t) { return 7u; })},
        {"id_of_the_quad",
         {"the id is the quad's, of two triangles each"},
         "zproof #43: one id per quad; three.js #3447: rays against quads",
         telling(scene, view, [](const Scene&, std::uint32_t id) { return id / 2; })},
        {"first_of_the_quad",
         {"both triangles of a quad have the first's id"},
         "zproof #43: one id per quad, the first triangle's",
         telling(scene, view, [](const Scene&, std::uint32_t id) { return id & ~1u; })},
        {"id_of_the_node",
         {"the id is the part's", "the id is the node's"},
         "azure-remote-rendering #43: a ray tells the part, not the triangle",
         telling(scene, view, part_of)},
        {"id_of_the_material",
         {"the id is the material's"},
         "zproof #43: many to one, the material",
         telling(scene, view,
                 [](const Scene& s, std::uint32_t id) {
                     return std::uint32_t(s.parts[part_of(s, id)].material);
                 })},
        {"ids_of_8_bits",
         {"ids keep their low 8 bits"},
         "BlenderProc #952, AirSim #2252: ids above 255 do not fit",
         telling(many, view, [](const Scene&, std::uint32_t id) { return id & 0xFFu; })},
        {"ids_clamped_to_8_bits",
         {"ids end at 255"},
         "AirSim #3765: one byte for each pixel, clamped",
         telling(many, view, [](const Scene&, std::uint32_t id) { return std::min(id, 255u); })},
        {"ids_of_16_bits",
         {"ids keep their low 16 bits"},
         "bpycv #41: ids stored as uint16",
         telling(hills(220), view, [](const Scene&, std::uint32_t id) { return id & 0xFFFFu; })},
        {"parts_in_another_order",
         {"ids are exchanged"},
         "trimesh #93: ids of another order of triangles",
         telling(scene, view, with_parts_reversed)},
    };
}

}  // namespace zproof::field
