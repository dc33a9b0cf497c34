/// Ids that stand for something else than the triangle's index.
#include <algorithm>
#include <cmath>

#include "tests/reports_from_the_field/field_frames.h"
#include "tests/reports_from_the_field/field_scenes.h"
#include "tests/reports_from_the_field/ray_caster.h"

namespace zproof::field_reports {

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
        {"ids_clamped_to_16_bits",
         {"ids end at 65535"},
         "bpycv #41: uint16, clamped",
         telling(hills(220), view, [](const Scene&, std::uint32_t id) { return std::min(id, 65535u); })},
        {"ids_as_half_floats",
         {"ids went through a float of 11 bits"},
         "zproof #43: ids in a half float channel",
         telling(hills(40), view,
                 [](const Scene&, std::uint32_t id) {
                     const double step = std::ldexp(1.0, std::max(0, std::ilogb(std::max(1u, id)) - 10));
                     return std::uint32_t(std::nearbyint(id / step) * step);
                 })},
        {"ids_of_vertices",
         {"the id is a vertex's"},
         "zproof #43: a flat attribute of the first vertex",
         telling(many, view,
                 [](const Scene& s, std::uint32_t id) {
                     return std::min(s.triangles[id].x, std::uint32_t(s.triangles.size()) - 1);
                 })},
        {"three_to_one",
         {"several triangles have one id"},
         "zproof #43: many to one, of unlike groups",
         telling(scene, view, [](const Scene&, std::uint32_t id) { return id / 3 * 3 % 391; })},
        {"too_large_by_one",
         {"ids are too large by one"},
         "nvdiffrast #137: the offset is left in, and background is written right",
         telling(scene, view, [](const Scene&, std::uint32_t id) { return id + 1; })},
        {"other_half_of_the_quad",
         {"even and odd ids change places"},
         "zproof #43: the quad's halves in another order",
         telling(scene, view, [](const Scene&, std::uint32_t id) { return id ^ 1u; })},
        {"within_the_part",
         {"ids restart in every part"},
         "pytorch3d #684: the index within the mesh, not within the batch",
         telling(
             scene, view,
             [](const Scene& s, std::uint32_t id) { return id - s.parts[part_of(s, id)].first_triangle; })},
        {"base_of_the_next_draw_call",
         {"ids are those of the next part"},
         "the counter of triangles is increased before a part is drawn",
         telling(
             scene, view,
             [](const Scene& s, std::uint32_t id) { return id + s.parts[part_of(s, id)].triangle_count; })},
        {"id_of_the_node_of_several_parts",
         {"the id is the node's"},
         "azure-remote-rendering #43, of nodes of two parts",
         [=] {
             Scene shared_nodes = scene;
             for (std::size_t k = 0; k < shared_nodes.parts.size(); ++k) {
                 shared_nodes.parts[k].node_index = int(k / 2);
                 shared_nodes.parts[k].node = "node " + std::to_string(k / 2);
             }
             return telling(shared_nodes, view,
                            [](const Scene& s, std::uint32_t id) { return part_of(s, id) / 2; })();
         }},
        {"ids_encoded_for_display",
         {"ids went through the curve of sRGB"},
         "an id texture of an sRGB format",
         telling(scene, view,
                 [](const Scene&, std::uint32_t id) {
                     const auto encoded = [](std::uint32_t byte) {
                         const double c = byte / 255.0;
                         const double code =
                             c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
                         return std::uint32_t(std::lround(255 * code));
                     };
                     return encoded(id & 0xFF) | encoded(id >> 8) << 8;
                 })},
        {"ids_taken_for_a_display",
         {"ids went through a curve of gamma 1/2.2"},
         "an id picture to which a colour transform was applied",
         telling(many, view,
                 [](const Scene&, std::uint32_t id) {
                     const auto linear = [](std::uint32_t byte) {
                         return std::uint32_t(std::lround(255 * std::pow(byte / 255.0, 2.2)));
                     };
                     return linear(id & 0xFF) | linear(id >> 8) << 8;
                 })},
        {"ids_hashed",
         {"ids have other numbers"},
         "a hash instead of the index",
         telling(scene, view, [](const Scene&, std::uint32_t id) { return (id + 1) * 2'654'435'761u; })},
        {"parts_in_another_order",
         {"ids are exchanged"},
         "trimesh #93: ids of another order of triangles",
         telling(scene, view, with_parts_reversed)},
    };
}

}  // namespace zproof::field_reports
