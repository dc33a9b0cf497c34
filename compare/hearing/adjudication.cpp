#include "compare/hearing/adjudication.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace zproof {

namespace {

/// Pixels that are open lie apart: each takes four lines of memory, which are asked for so many pixels ahead.
constexpr std::size_t fetched_ahead = 16;

}  // namespace

Rulings rule_on(const Scene& scene, const View& view, const Witness& candidate, const Witness& reference,
                std::span<const PixelPlace> open, Asked asked) {
    const std::size_t triangle_count = scene.triangles.size();
    const auto plea = [&](const Witness& witness, const Answer& answer, const PixelPlace& place) {
        return is_invalid(answer, triangle_count)
                   ? Plea{}
                   : Plea{&witness.bounds(), answer.primitive, place.x, place.y};
    };
    const auto fetch = [](const Witness& witness, const PixelPlace& place) {
        __builtin_prefetch(&witness.frame().primitive.at(place.x, place.y));
        __builtin_prefetch(&witness.frame().camera_depth.at(place.x, place.y));
    };
    Bulk<Plea> pleas(2 * open.size());
    tbb::parallel_for(std::size_t(0), open.size(), [&](std::size_t i) {
        const PixelPlace &place = open[i], &later = open[std::min(i + fetched_ahead, open.size() - 1)];
        fetch(candidate, later);
        fetch(reference, later);
        const Answer ours = candidate.answer_at(place.x, place.y),
                     theirs = reference.answer_at(place.x, place.y);
        const bool differ = ours.primitive != theirs.primitive;
        pleas[2 * i] = differ ? plea(candidate, ours, place) : Plea{};
        pleas[2 * i + 1] = differ ? plea(reference, theirs, place) : Plea{};
    });
    return Rulings(Hearing(scene, view).hear(std::move(pleas), asked));
}

PixelClass class_of(const OpenPixel& open, const Ruling& ruling) {
    if (open.candidate_invalid) return PixelClass::invalid;
    const Standing candidate = ruling.candidate.decision.standing,
                   reference = ruling.reference.decision.standing;
    if (!is_lawful(candidate)) return class_of(candidate, reference);
    if (!open.candidate_depth_lawful) return PixelClass::wrong_depth;
    if (open.reference_invalid || !open.reference_depth_lawful) return PixelClass::reference_wrong;
    return class_of(candidate, reference);
}

}  // namespace zproof
