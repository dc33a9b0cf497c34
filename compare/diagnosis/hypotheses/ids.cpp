#include <algorithm>
#include <bit>
#include <cmath>

#include "compare/diagnosis/hypotheses/catalogue.h"
#include "compare/diagnosis/hypotheses/renamed_ids.h"

namespace zproof {

namespace {

Hypothesis with_ids(const DiagnosisInput& input, const Cause& cause, const Renamed& meant) {
    Hypothesis h = as_declared(input, cause);
    h.restate = [meant, count = input.scene.triangles.size()](Claim claim) -> std::optional<Claim> {
        if (claim.answer.primitive == PrimitiveId::none) return claim;
        const std::uint32_t id = meant(std::uint32_t(claim.answer.primitive));
        if (id >= count) return std::nullopt;
        claim.answer.primitive = PrimitiveId(id);
        return claim;
    };
    return h;
}

/// The number of the triangle at the same place `step` parts further. Behind the last part it is no
/// triangle's.
std::uint32_t in_part(const Scene& scene, std::uint32_t triangle, int step) {
    const std::size_t part = part_of(scene, triangle), other = part + std::size_t(step);
    if (other > scene.parts.size()) return nobody;
    const std::size_t base =
        other < scene.parts.size() ? scene.parts[other].first_triangle : scene.triangles.size();
    return triangle - scene.parts[part].first_triangle + std::uint32_t(base);
}

std::vector<Hypothesis> of_parts(const DiagnosisInput& input) {
    const Scene& scene = input.scene;
    if (scene.parts.size() < 2) return {};
    const auto first_in = [&scene](std::uint32_t id) {
        return scene.parts[part_of(scene, id)].first_triangle;
    };
    const char* base = "Look at the base id of each draw call: it is that of another part.";
    return {with_ids_reported_as(
                input,
                {"ids restart in every part",
                 "An id counts triangles from the first of its part (a glTF primitive).",
                 "Look at gl_PrimitiveID and its like: add the triangles of the draw calls before."},
                [=](std::uint32_t id) { return id - first_in(id); }),
            with_ids_reported_as(input,
                                 {"ids are those of the next part",
                                  "An id names the triangle at the same place in the next part.", base},
                                 [&scene](std::uint32_t id) { return in_part(scene, id, 1); }),
            with_ids_reported_as(input,
                                 {"ids are those of the part before",
                                  "An id names the triangle at the same place in the part before.", base},
                                 [&scene](std::uint32_t id) { return in_part(scene, id, -1); }),
            with_ids_reported_as(
                input,
                {"the id is the part's", "An id is the index of the triangle's part.",
                 "Look at what the id buffer is given: the draw call's index, not the triangle's."},
                [&scene](std::uint32_t id) { return std::uint32_t(part_of(scene, id)); })};
}

/// Ids that kept this many low bits.
Hypothesis of_low_bits(const DiagnosisInput& input, int bits) {
    return with_ids_reported_as(
        input,
        {"ids keep their low " + std::to_string(bits) + " bits",
         "An id is the triangle's modulo 2^" + std::to_string(bits) + ".",
         "Look at the id buffer's format, and at the format of the file: it has too few bits."},
        [=](std::uint32_t id) { return id & ((1u << bits) - 1); });
}

/// Ids that went through a float of this many significant bits, rounded to nearest, ties to even.
Hypothesis of_float(const DiagnosisInput& input, int bits) {
    const auto rounded = [=](std::uint32_t id) {
        const double step = std::ldexp(1.0, std::max(0, int(std::bit_width(id)) - bits));
        return std::uint32_t(std::nearbyint(id / step) * step);
    };
    return with_ids_reported_as(
        input,
        {"ids went through a float of " + std::to_string(bits) + " bits",
         "An id is the triangle's, rounded to " + std::to_string(bits) + " significant bits.",
         "Look for a float between the id and the file: write ids as unsigned integers."},
        rounded);
}

std::vector<Hypothesis> of_lost_bits(const DiagnosisInput& input) {
    const int bits = int(std::bit_width(input.scene.triangles.size()));
    std::vector<Hypothesis> all;
    for (const int kept : {24, 20, 16, 12, 8})
        if (kept < bits) all.push_back(of_low_bits(input, kept));
    for (const int kept : {24, 11})
        if (kept < bits) all.push_back(of_float(input, kept));
    return all;
}

Hypothesis of_vertices(const DiagnosisInput& input) {
    const auto& triangles = input.scene.triangles;
    return with_ids_reported_as(
        input,
        {"the id is a vertex's", "An id is the index of the triangle's first vertex.",
         "Look at flat attributes: the id comes from the provoking vertex, not from the primitive."},
        [&](std::uint32_t id) { return std::min(triangles[id].x, std::uint32_t(triangles.size()) - 1); });
}

/// Ids lie elsewhere than the depths that belong to them; at the outline, where there is none to be had,
/// they stay.
Hypothesis apart_from_depths(const DiagnosisInput& input, int dx, int dy, const std::string& where) {
    Hypothesis h = as_declared(input, {"ids lie one pixel " + where + " of their depths",
                                       "The id of a pixel belongs to its neighbour's depth.",
                                       "Look at the offsets at which the id plane is read or written."});
    h.reads_surroundings = true;
    h.restate = [dx, dy, &frame = input.candidate.frame](Claim claim) -> std::optional<Claim> {
        const Claim moved{claim.x - dx, claim.y - dy, claim.answer};
        if (!holds(frame.size(), moved)) return std::nullopt;
        const float depth = frame.camera_depth.at(moved.x, moved.y);
        const bool outline = depth == background_depth && claim.answer.primitive != PrimitiveId::none;
        return outline ? claim : Claim{moved.x, moved.y, {claim.answer.primitive, depth}};
    };
    return h;
}

/// One more than the index, and 0 where nothing is seen.
Hypothesis from_one(const DiagnosisInput& input) {
    Hypothesis h = as_declared(
        input,
        {"ids count from 1, and 0 is background",
         "An id is the triangle's index plus 1, or 0 where nothing is seen.",
         "Look at how the id buffer is read: 0 means nothing there; subtract 1 and write 0xFFFFFFFF for 0."});
    h.restate = [](Claim claim) -> std::optional<Claim> {
        const std::uint32_t id = std::uint32_t(claim.answer.primitive);
        if (id == nobody) return std::nullopt;
        claim.answer.primitive = id == 0 ? PrimitiveId::none : PrimitiveId(id - 1);
        return claim;
    };
    return h;
}

Hypothesis exchanged(const DiagnosisInput& input) {
    const auto ours = input.candidate.frame.primitive.pixels(),
               theirs = input.reference.frame.primitive.pixels();
    const Ids there = most_often_with(ours, theirs), back = most_often_with(theirs, ours);
    const auto meant = [there, back](std::uint32_t id) {
        const auto triangle = there.find(id);
        if (triangle != there.end()) return back.at(triangle->second) == id ? triangle->second : id;
        const auto other = back.find(id);  // the triangle of that index has another's id
        return other != back.end() && there.at(other->second) == id ? nobody : id;
    };
    const bool are_triangles = std::ranges::all_of(
        there, [&](const auto& pair) { return pair.first < input.scene.triangles.size(); });
    const char* one_to_one =
        "An id stands for one other triangle, and that for no other id, wherever they occur.";
    Hypothesis h = with_ids(
        input,
        are_triangles
            ? Cause{"ids are exchanged", one_to_one,
                    "Look at whatever sorts or reorders triangles (BVH build, vertex cache) and keep the "
                    "original index."}
            : Cause{"ids have other numbers", one_to_one,
                    "Look at what is written for an id: a hash, a handle, an address, or a colour."},
        meant);
    const auto changed =
        std::ranges::count_if(there, [&](const auto& pair) { return meant(pair.first) != pair.first; });
    h.learned_bits = 2 * double(changed) * bits_of_an_id(input);
    return h;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_ids(const DiagnosisInput& input) {
    const auto count = std::uint32_t(input.scene.triangles.size());
    const char* counter =
        "Look at where the id is made: a counter that is increased too early or too late, "
        "or a 0 that means nothing.";
    std::vector<Hypothesis> all{
        with_ids(input, {"ids are too large by one", "An id is the triangle's index plus 1.", counter},
                 [](std::uint32_t id) { return id - 1; }),
        from_one(input),
        with_ids_reported_as(
            input, {"ids are too small by one", "An id is the triangle's index minus 1, 0 for 0.", counter},
            [](std::uint32_t id) { return id == 0 ? 0 : id - 1; }),
        with_ids(input,
                 {"even and odd ids change places", "Of two triangles in a row, each bears the other's id.",
                  "Look at how a quad is cut into triangles, and in which order they are listed."},
                 [](std::uint32_t id) { return id ^ 1; }),
        with_ids(input,
                 {"ids count from the last triangle", "An id is N - 1 - i of the triangle i.",
                  "Look at the order in which triangles are submitted or numbered."},
                 [=](std::uint32_t id) { return count - 1 - id; }),
        apart_from_depths(input, 1, 0, "right"),
        apart_from_depths(input, -1, 0, "left"),
        apart_from_depths(input, 0, 1, "below"),
        apart_from_depths(input, 0, -1, "above")};
    for (const auto& more : {of_parts(input), of_lost_bits(input)})
        all.insert(all.end(), more.begin(), more.end());
    for (const ByteCurve& curve : byte_curves())
        all.push_back(with_ids_reported_as(input, curve.cause("ids"), curve));
    all.push_back(of_vertices(input));
    all.push_back(exchanged(input));
    return all;
}

}  // namespace zproof
