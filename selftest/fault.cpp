#include "selftest/fault.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "selftest/catalogue.h"

namespace zproof::selftest {
namespace {

std::uint64_t pixels_of(const Verdict& verdict, PixelClass c) { return verdict.counts[std::size_t(c)]; }

bool every_class_occurs(const Expected& expected, const Verdict& verdict) {
    return std::ranges::all_of(expected.classes, [&](PixelClass c) { return pixels_of(verdict, c) > 0; });
}

bool count_is_met(const Expected& expected, const Verdict& verdict) {
    if (!expected.count) return true;
    std::uint64_t named = 0, named_failing = 0;
    for (const PixelClass c : expected.classes) {
        named += pixels_of(verdict, c);
        if (!passes(c)) named_failing += pixels_of(verdict, c);
    }
    return named == *expected.count && defect_count(verdict) == named_failing;
}

bool meets(const Expected& expected, const Verdict& verdict) {
    if (expected.answer == Expected::Answer::refuse) return false;
    const bool failed = defect_count(verdict) > 0;
    return failed == (expected.answer == Expected::Answer::fail) && every_class_occurs(expected, verdict) &&
           count_is_met(expected, verdict);
}

std::optional<Verdict> verdict_on(const Fault& fault, const Fixture& fixture) {
    const Frame faulty = fault.inject(fixture);
    const bool instead_of_reference = fault.target == Target::reference;
    const Frame& candidate = instead_of_reference ? fixture.good : faulty;
    const Frame& reference = instead_of_reference ? faulty : fixture.reference;
    const bool renderers = fault.precision_source == PrecisionSource::of_renderer;
    const Precision& precision = renderers ? fixture.precision : fixture.reference_precision;
    try {
        return judge(fixture.scene, fixture.view, {candidate, precision},
                     {reference, fixture.reference_precision});
    } catch (const std::invalid_argument&) {  // what the judge says of frames that are none of this view's
        return std::nullopt;
    }
}

}  // namespace

std::vector<Fault> catalogue() {
    std::vector<Fault> all;
    for (const auto part : {clean_frames, faults_of_a_pixel, faults_of_ids, faults_of_depth,
                            faults_of_attributes, faults_of_place, faults_of_visibility})
        std::ranges::move(part(), std::back_inserter(all));
    return all;
}

FaultResult try_fault(const Fault& fault, const Fixture& fixture) {
    FaultResult result{.verdict = verdict_on(fault, fixture)};
    result.as_expected = result.verdict ? meets(fault.expected, *result.verdict)
                                        : fault.expected.answer == Expected::Answer::refuse;
    return result;
}

std::string in_words(const FaultResult& result) {
    if (!result.verdict) return "refused";
    std::string words;
    for (int c = int(PixelClass::reference_wrong); c < pixel_class_count; ++c) {
        const std::uint64_t count = pixels_of(*result.verdict, PixelClass(c));
        if (count == 0) continue;
        words +=
            (words.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(name_of(PixelClass(c)));
    }
    return words.empty() ? "no defect" : words;
}

}  // namespace zproof::selftest
