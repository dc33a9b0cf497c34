#include "compare/presort.h"

#include <algorithm>
#include <bit>

#include "compare/masks.h"

namespace zproof {

namespace {

/// Where the candidate shows nothing, and both have the depth of the background.
ColumnMask bare(const Strip& strip, std::size_t first) {
    const ColumnMask nothing = where_equal(&strip.candidate.primitive[first], PrimitiveId::none);
    if (nothing == 0) return 0;
    return nothing & where_equal(&strip.candidate.camera_depth[first], background_depth) &
           where_equal(&strip.reference.camera_depth[first], background_depth);
}

ColumnsOfBoth without(const ColumnsOfBoth& all, const ColumnsOfBoth& some) {
    return {all.candidate & ~some.candidate, all.reference & ~some.reference};
}
bool is_none(const ColumnsOfBoth& columns) { return (columns.candidate | columns.reference) == 0; }

}  // namespace

void Presort::sort(const LawsOfBoth& laws, Largest& largest, const Strip& strip, SortedStrip& sorted) {
    known_.resize(std::max(known_.size(), laws.candidate.size()));
    if (is_of_one_triangle(laws, largest, strip)) {
        sorted.sorted = SortedStrip::all_sorted;
        sorted.open = sorted.lawful = {};
        return;
    }
    const std::uint32_t* const ours = strip.candidate.law.data();
    const std::uint32_t* const theirs = strip.differ == 0 ? ours : strip.reference.law.data();
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk) {
        constexpr ColumnMask but_first = all_columns & ~ColumnMask{1};
        const bool one =
            ((Strip::in_chunk(strip.turns, first) & but_first) | Strip::in_chunk(strip.differ, first)) == 0;
        const Source source{laws, largest, strip, first, ours + first, theirs + first};
        const bool is_sorted =
            one && ours[first] != 0 ? sort_one_law(source, sorted) : sort_some_laws(source, sorted);
        sorted.sorted |= std::uint32_t(is_sorted) << first / Strip::chunk;
    }
}

/// All of it, and certain.
bool Presort::is_of_one_triangle(const LawsOfBoth& laws, const Largest& largest, const Strip& strip) {
    const std::uint32_t law = strip.candidate.law[0];
    if (strip.turns != 1 || strip.differ != 0 || law == 0) return false;
    const DepthTolerance& tolerance = known_by(law, laws).tolerance;
    return tolerance.is_usable &&
           are_all_certain(tolerance, projection_,
                           {{strip.x, strip.y}, strip.candidate.camera_depth, strip.reference.camera_depth},
                           {largest.candidate, largest.reference}, Strip::width / Strip::chunk);
}

Presort::Known& Presort::known_by(std::uint32_t law, const LawsOfBoth& laws) {
    Known& known = known_[law];
    if (known.tile != tile_number_)
        known = {.tile = tile_number_,
                 .tolerance = tolerance_of(laws.candidate[law], laws.reference[law], projection_, tile_,
                                           Reach::but_corners),
                 .candidate = {},
                 .reference = {}};
    return known;
}

/// Of those pixels, where depths are lawful for certain. Where both frames show the triangle, the largest are
/// raised.
ColumnsOfBoth Presort::lawful_by(std::uint32_t law, const ColumnsOfBoth& here, const Source& source) {
    Known& known = known_by(law, source.laws);
    const ColumnMask counted = here.candidate & here.reference;
    const ColumnsOfBoth left = uncertain_by(known.tolerance, {here, counted}, source);
    if (is_none(left)) return here;
    const PartsOfBoth parts = parts_of(source, law, known);
    if (is_none(without(left, level_ones(parts)))) {
        if ((left.candidate & counted) != 0) parts.candidate.raise(parts.candidate.level.ratio);
        if ((left.reference & counted) != 0) parts.reference.raise(parts.reference.level.ratio);
        return here;
    }
    return lawful_in_full(here, uncertain_here(law, {left, counted}, source), parts, source.place());
}

Presort::PartsOfBoth Presort::parts_of(const Source& source, std::uint32_t law, Known& known) {
    return {{source.laws.candidate[law], &source.strip.candidate.camera_depth[source.first], known.candidate,
             source.largest.candidate},
            {source.laws.reference[law], &source.strip.reference.camera_depth[source.first], known.reference,
             source.largest.reference}};
}

/// Whose ratio is known.
ColumnsOfBoth Presort::level_ones(const PartsOfBoth& parts) {
    const DepthLaw& plane = parts.candidate.law;
    if (plane.nearness_per_x != 0 || plane.nearness_per_y != 0) return {};
    return {where_equal(parts.candidate.camera_depth, parts.candidate.level.depth),
            where_equal(parts.reference.camera_depth, parts.reference.level.depth)};
}

ColumnsOfBoth Presort::uncertain_by(const DepthTolerance& tolerance, const Question& asked,
                                    const Source& source) const {
    if (!tolerance.is_usable) return asked.pixels;
    const DepthsOfBoth depths{source.place(), &source.strip.candidate.camera_depth[source.first],
                              &source.strip.reference.camera_depth[source.first]};
    ColumnsOfBoth left = asked.pixels;
    if (asked.counted != 0)
        left = without(left, certain_depths(tolerance, projection_, depths, source.at_most()));
    const ColumnMask lone = (left.candidate | left.reference) & ~asked.counted;
    if (lone == 0) return left;
    const ColumnsOfBoth certain = certain_depths(tolerance, projection_, depths, {});
    return without(left, {certain.candidate & lone, certain.reference & lone});
}

/// What holds in the chunk alone says more.
ColumnsOfBoth Presort::uncertain_here(std::uint32_t law, Question asked, const Source& source) const {
    const auto [left, y] = source.place();
    const PixelBox chunk{left, y, left + int(tile_columns), y + 1};
    for (const Reach reach : {Reach::but_corners, Reach::all}) {
        const DepthTolerance tolerance =
            tolerance_of(source.laws.candidate[law], source.laws.reference[law], projection_, chunk, reach);
        asked.pixels = uncertain_by(tolerance, asked, source);
    }
    return asked.pixels;
}

/// Those of them that are asked about are held against the whole formula.
ColumnsOfBoth Presort::lawful_in_full(const ColumnsOfBoth& here, const ColumnsOfBoth& asked,
                                      const PartsOfBoth& parts, const RowPlace& place) const {
    TileRow our_ratio, their_ratio;
    const ColumnsOfBoth lawful{
        here.candidate & ~unlawful_in_full(parts.candidate, asked.candidate, place, our_ratio),
        here.reference & ~unlawful_in_full(parts.reference, asked.reference, place, their_ratio)};
    const ColumnMask counted = lawful.candidate & lawful.reference;
    parts.candidate.raise(our_ratio, counted & asked.candidate);
    parts.reference.raise(their_ratio, counted & asked.reference);
    return lawful;
}

ColumnMask Presort::unlawful_in_full(const Part& part, ColumnMask asked, const RowPlace& place,
                                     TileRow& ratio) const {
    if (asked == 0) return 0;
    TileRowOf<float> depth;
    std::copy_n(part.camera_depth, tile_columns, depth.begin());
    ratio = depths_in_row(part.law, projection_, place, depth).ratio;
    const ColumnMask lawful = asked & at_least_zero(ratio);
    if (const auto i = std::size_t(std::countr_zero(lawful)); lawful != 0)
        part.level = {part.camera_depth[i], ratio[i]};
    return asked & ~lawful;
}

void Presort::Part::raise(const TileRow& ratio, ColumnMask pixels) const {
    for (; pixels != 0; pixels &= pixels - 1) raise(ratio[std::size_t(std::countr_zero(pixels))]);
}

/// Unless a depth is not lawful for certain.
bool Presort::sort_one_law(const Source& source, SortedStrip& sorted) {
    const auto [ours, theirs] = lawful_by(source.ours[0], {all_columns, all_columns}, source);
    const std::size_t chunk = source.first / Strip::chunk;
    sorted.open[chunk] = sorted.lawful[chunk] = 0;
    return (ours & theirs) == all_columns;
}

/// Triangle by triangle; unless a pixel at which the frames agree is not lawful for certain.
bool Presort::sort_some_laws(const Source& source, SortedStrip& sorted) {
    const ColumnMask same = ~Strip::in_chunk(source.strip.differ, source.first) & all_columns;
    const ColumnMask in_question = all_columns & ~(same & bare(source.strip, source.first));
    ColumnsOfBoth left{in_question, in_question};
    ColumnMask lawful = in_question;
    while (!is_none(left)) {
        const std::uint32_t law = left.candidate != 0 ? source.ours[std::countr_zero(left.candidate)]
                                                      : source.theirs[std::countr_zero(left.reference)];
        const ColumnsOfBoth here{left.candidate & where_equal(source.ours, law),
                                 left.reference & where_equal(source.theirs, law)};
        const ColumnsOfBoth found = law == 0 ? ColumnsOfBoth{} : lawful_by(law, here, source);
        lawful &= ~((here.candidate & ~found.candidate) | (here.reference & ~found.reference));
        if ((same & in_question & ~lawful) != 0) return false;
        left = without(left, here);
    }
    const std::size_t chunk = source.first / Strip::chunk;
    sorted.open[chunk] = ~same & all_columns;
    sorted.lawful[chunk] = sorted.open[chunk] & lawful;
    return true;
}

}  // namespace zproof
