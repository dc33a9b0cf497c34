#include "compare/first_pass/presort.h"

#include <algorithm>
#include <bit>

#include "compare/strips/masks.h"

namespace zproof {

namespace {

ColumnsOfBoth without(const ColumnsOfBoth& all, const ColumnsOfBoth& some) {
    return {all.candidate & ~some.candidate, all.reference & ~some.reference};
}
bool is_none(const ColumnsOfBoth& columns) { return (columns.candidate | columns.reference) == 0; }

/// At one depth all over the image: there a depth that was lawful and counted is so again.
bool is_level(const DepthTolerance& t) { return t.w_per_x == 0 && t.w_per_y == 0; }

strips::Depths in_kernel(const Strip& strip, Strip::Pixels asked) {
    return {.x = strip.x,
            .y = strip.y,
            .primitive = strip.candidate.primitive,
            .candidate = strip.candidate.camera_depth,
            .reference = strip.reference.camera_depth,
            .turns = strip.turns,
            .asked = asked,
            .law_of_run = strip.law_of_run.data()};
}

/// Where what is shown has no law.
Strip::Pixels lawless_among(const Strip::ShownOnes& shown) {
    Strip::Pixels found = 0;
    for (int i = 0; i < shown.count; ++i)
        if (const auto& [law, pixels] = shown.of[std::size_t(i)]; law == 0) found |= pixels;
    return found;
}

/// In chunks with any of the pixels, and there of all.
Strip::Pixels where_equal_in(Strip::Pixels pixels, const float* depths, float depth) {
    Strip::Pixels found = 0;
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk)
        if (Strip::in_chunk(pixels, first) != 0)
            found |= Strip::Pixels{where_equal(depths + first, depth)} << first;
    return found;
}

}  // namespace

Presort::Presort(const Scene& scene, const Witness& candidate, const Witness& reference,
                 const strips::Kernel& kernel)
    : scene_(scene),
      projection_(candidate.projection()),
      kernel_(kernel),
      lens_(run_lens_of(scene, candidate, reference)) {}

void Presort::turn_to(const PixelBox& tile, const ShownTriangles& shown) {
    if (lens_) {
        tolerances_.resize(shown.count() + 1);
        tolerances_[0] = tolerance_of_nothing;
        set_tolerances(kernel_, *lens_, scene_, {shown.triangles(), tile}, std::span(tolerances_).subspan(1));
    } else {
        shown.set_tolerances(tile, tolerances_, corner_tolerances_);
    }
    met_.assign(tolerances_.size(), {});
    met_level_ = false;
}

void Presort::turn_to_unknown() {
    tolerances_.clear();
    met_.clear();
}

void Presort::sort(ShownTriangles& shown, Largest& largest, const Strip& strip, SortedStrip& sorted) {
    const Strip::Pixels certain = certain_where_same(strip, largest);
    const Decided decided = strip.differ != 0 ? decided_where_they_differ(strip) : Decided{};
    sort_chunks(shown, largest, strip, {certain | decided.all, decided.lawful}, sorted);
}

Strip::Pixels Presort::certain_by_corners(const Largest& largest, const Strip& strip,
                                          const strips::Runs& runs) const {
    return ~strip.differ & kernel_.certain_by_corners(in_kernel(strip, ~strip.differ), runs, *lens_,
                                                      {largest.candidate, largest.reference});
}

void Presort::sort_others(ShownTriangles& shown, Largest& largest, const Strip& strip, Strip::Pixels certain,
                          SortedStrip& sorted) {
    tolerances_.resize(shown.count() + 1, tolerance_of_nothing);
    met_.resize(tolerances_.size());
    sort_chunks(shown, largest, strip, {.all = certain, .lawful = 0}, sorted);
}

/// All pixels that are not decided.
void Presort::sort_chunks(ShownTriangles& shown, Largest& largest, const Strip& strip, const Decided& decided,
                          SortedStrip& sorted) {
    sorted.sorted = SortedStrip::all_sorted;
    for (std::size_t chunk = 0; chunk < sorted.open.size(); ++chunk) {
        sorted.open[chunk] = Strip::in_chunk(strip.differ, chunk * Strip::chunk);
        sorted.lawful[chunk] = Strip::in_chunk(decided.lawful, chunk * Strip::chunk);
    }
    if (decided.all == Strip::all) return;
    const LawsAlong along = laws_along(strip);
    const std::uint32_t *const ours = along.candidate.data(), *const theirs = along.reference.data();
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk) {
        const ColumnMask settled = Strip::in_chunk(decided.all, first);
        if (settled == all_columns) continue;
        const Source source{shown, largest, strip, first, ours + first, theirs + first, settled};
        if (!sort_chunk(source, sorted)) sorted.sorted &= ~(1u << first / Strip::chunk);
    }
}

/// Where both show the same triangle. Of a level one, of which some were met, most were.
Strip::Pixels Presort::certain_where_same(const Strip& strip, const Largest& largest) const {
    const Strip::Pixels asked = ~strip.differ;
    const Strip::Pixels level = met_level_ ? certain_where_level(strip, largest, asked) : 0;
    return level | certain_if_same(strip, largest, asked & ~level);
}

/// Of those pixels.
Strip::Pixels Presort::certain_if_same(const Strip& strip, const Largest& largest,
                                       Strip::Pixels asked) const {
    if (asked == 0) return 0;
    return kernel_.certain(in_kernel(strip, asked), {.tolerances = tolerances_.data(),
                                                     .next_to_corners = corner_tolerances(),
                                                     .projection = projection_,
                                                     .candidate_at_most = largest.candidate,
                                                     .reference_at_most = largest.reference});
}

/// Of those pixels, where it is level, and one renderer's depth has been met and the other's too or is
/// certain.
Strip::Pixels Presort::certain_where_level(const Strip& strip, const Largest& largest,
                                           Strip::Pixels asked) const {
    constexpr double any = std::numeric_limits<double>::infinity();
    const PixelsOfBoth met = met_where_level(strip, asked);
    const Strip::Pixels both = met.candidate & met.reference;
    return both | certain_if_same(strip, {any, largest.reference}, met.candidate & ~both) |
           certain_if_same(strip, {largest.candidate, any}, met.reference & ~both);
}

/// Where the tile's tolerances say that both depths are lawful; no more is asked where one shows nothing that
/// has a law.
auto Presort::decided_where_they_differ(const Strip& strip) const -> Decided {
    const auto decide = [&](const Strip::ShownOnes& shown, const float* camera_depth,
                            DepthTolerance::Bound DepthTolerance::*bound,
                            CornerTolerance::Bound CornerTolerance::*bound_there) {
        return Decided{.all = lawless_among(shown),
                       .lawful = kernel_.lawful(
                           {strip.x, strip.y, camera_depth, shown.of.data(), shown.count, bound, bound_there},
                           {.tolerances = tolerances_.data(),
                            .next_to_corners = corner_tolerances(),
                            .projection = projection_})};
    };
    const Decided ours = decide(candidates_where_they_differ(strip), strip.candidate.camera_depth,
                                &DepthTolerance::candidate, &CornerTolerance::candidate),
                  theirs = decide(strip.others, strip.reference.camera_depth, &DepthTolerance::reference,
                                  &CornerTolerance::reference);
    const Strip::Pixels lawful = ours.lawful & theirs.lawful;
    return {.all = ours.all | theirs.all | lawful, .lawful = lawful};
}

auto Presort::met_where_level(const Strip& strip, Strip::Pixels asked) const -> PixelsOfBoth {
    PixelsOfBoth met;
    const std::uint32_t* law = strip.law_of_run.data();
    for (Strip::Pixels turns = strip.turns; turns != 0; ++law) {
        const Strip::Pixels run = asked & Strip::take_run(turns);
        if (run == 0 || !is_level(tolerances_[*law])) continue;
        const auto& [candidate, reference] = met_[*law];
        met.candidate |= run & where_equal_in(run, strip.candidate.camera_depth, candidate);
        met.reference |= run & where_equal_in(run, strip.reference.camera_depth, reference);
    }
    return met;
}

/// Of those pixels, where depths are lawful for certain. Where both frames show the triangle, the largest are
/// raised.
ColumnsOfBoth Presort::lawful_by(std::uint32_t law, const ColumnsOfBoth& here, const Source& source) {
    const ColumnMask counted = here.candidate & here.reference;
    const CornerTolerance* const corners = corner_tolerances();
    const ColumnsOfBoth left =
        uncertain_by({&tolerances_[law], corners ? corners + law : nullptr}, {here, counted}, source);
    if (is_none(left)) return here;
    if (is_none(without(left, met_already(law, source)))) return here;
    met_level_ |= is_level(tolerances_[law]);
    const PartsOfBoth parts = parts_of(source, law);
    return lawful_in_full(here, uncertain_here(law, {left, counted}, source), parts, source.place());
}

Presort::PartsOfBoth Presort::parts_of(const Source& source, std::uint32_t law) {
    Met& met = met_[law];
    const LawsOfBoth& laws = source.shown.laws();
    return {{laws.candidate[law], &source.strip.candidate.camera_depth[source.first], met.candidate,
             source.largest.candidate},
            {laws.reference[law], &source.strip.reference.camera_depth[source.first], met.reference,
             source.largest.reference}};
}

ColumnsOfBoth Presort::met_already(std::uint32_t law, const Source& source) const {
    if (!is_level(tolerances_[law])) return {};
    return {where_equal(&source.strip.candidate.camera_depth[source.first], met_[law].candidate),
            where_equal(&source.strip.reference.camera_depth[source.first], met_[law].reference)};
}

ColumnsOfBoth Presort::uncertain_by(const ToleratedBy& by, const Question& asked,
                                    const Source& source) const {
    const DepthsOfBoth depths{source.place(), &source.strip.candidate.camera_depth[source.first],
                              &source.strip.reference.camera_depth[source.first]};
    ColumnsOfBoth left = asked.pixels;
    if (asked.counted != 0)
        left = without(
            left, certain_depths(*by.far_off, by.next_to_corners, projection_, depths, source.at_most()));
    const ColumnMask lone = (left.candidate | left.reference) & ~asked.counted;
    if (lone == 0) return left;
    const ColumnsOfBoth certain = certain_depths(*by.far_off, by.next_to_corners, projection_, depths, {});
    return without(left, {certain.candidate & lone, certain.reference & lone});
}

/// What holds in the chunk alone says more.
ColumnsOfBoth Presort::uncertain_here(std::uint32_t law, const Question& asked, const Source& source) const {
    const auto [left, y] = source.place();
    const PixelBox chunk{left, y, left + int(tile_columns), y + 1};
    const LawsOfBoth& laws = source.shown.laws();
    const auto [far_off, next_to_corners] =
        tolerances_of(laws.candidate[law], laws.reference[law], projection_, chunk);
    return uncertain_by({&far_off, &next_to_corners}, asked, source);
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
    return asked & ~at_least_zero(ratio);
}

void Presort::Part::raise(const TileRow& ratio, ColumnMask pixels) const {
    for (; pixels != 0; pixels &= pixels - 1) {
        const auto i = std::size_t(std::countr_zero(pixels));
        largest = std::max(largest, ratio[i]);
        met = camera_depth[i];
    }
}

/// Triangle by triangle; unless a pixel at which the frames agree is not lawful for certain.
bool Presort::sort_chunk(const Source& source, SortedStrip& sorted) {
    const ColumnMask same = ~Strip::in_chunk(source.strip.differ, source.first) & all_columns;
    const ColumnMask in_question = all_columns & ~source.settled;
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
    sorted.lawful[chunk] |= sorted.open[chunk] & lawful;
    return true;
}

}  // namespace zproof
