#include "compare/diagnosis/attribute_causes.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "compare/diagnosis/attribute_readings.h"
#include "compare/diagnosis/description.h"

namespace zproof {

namespace {

constexpr std::size_t first_pixels =
    32;  ///< wrong pixels of which a reading must explain one to be asked more
constexpr std::size_t most_pixels = 1000;                      ///< pixels of either kind
constexpr std::size_t most_beside = 3, most_others_wrong = 2;  ///< explanations, and further attributes

using Pixels = std::vector<PixelCoord>;

/// Some of them, evenly spread.
Pixels evenly(const Pixels& all, std::size_t most) {
    Pixels some;
    const std::size_t count = std::min(all.size(), most);
    for (std::size_t k = 0; k < count; ++k) some.push_back(all[k * all.size() / count]);
    return some;
}

Pixels wrong_pixels(const Verdict& verdict) {
    Pixels wrong;
    for (const Finding& f : verdict.findings)
        if (f.verdict == PixelClass::wrong_attribute) wrong.push_back({f.x, f.y});
    return wrong;
}

/// Those that show a triangle.
Pixels agreeing_pixels(const Frame& frame, const Verdict& verdict) {
    Pixels agreeing;
    for (int y = 0; y < frame.size().height; ++y)
        for (int x = 0; x < frame.size().width; ++x)
            if (verdict.classes.at(x, y) == PixelClass::agree &&
                frame.primitive.at(x, y) != PrimitiveId::none)
                agreeing.push_back({x, y});
    return agreeing;
}

/// What became of the readings of one attribute: the first that explain all and contradict nothing, then
/// those that explain the most.
struct AttributeOutcome {
    std::uint64_t wrong = 0;  ///< values, of the pixels asked
    std::vector<Explanation> readings;

    bool has_cause() const { return !readings.empty() && explains_all(readings.front()); }
    static bool explains_all(const Explanation& e) { return e.explained == e.asked && e.contradicted == 0; }
};

class AttributeDiagnoser {
  public:
    AttributeDiagnoser(const DiagnosisInput& input, const Verdict& verdict)
        : input_(input),
          check_(input.scene, input.view, input.candidate.frame, input.candidate.precision),
          wrong_(wrong_pixels(verdict)),
          asked_wrong_(evenly(wrong_, most_pixels)),
          asked_agreeing_(evenly(agreeing_pixels(input.candidate.frame, verdict), most_pixels)) {}

    std::optional<Diagnosis> run() const {
        if (wrong_.empty()) return std::nullopt;
        std::vector<AttributeOutcome> outcomes;
        for (const Attribute attribute : check_.judged()) outcomes.push_back(outcome_of(attribute));
        std::ranges::stable_sort(outcomes, std::greater{}, [](const AttributeOutcome& o) {
            return std::pair{o.has_cause(), o.wrong};
        });
        Diagnosis diagnosis{.defects = wrong_.size(), .cause = {}, .further = {}, .runners_up = {}};
        std::span<const Explanation> others = outcomes.front().readings;
        if (outcomes.front().has_cause()) {
            diagnosis.cause = others.front();
            others = others.subspan(1);
        }
        diagnosis.runners_up.assign(others.begin(),
                                    others.begin() + std::ptrdiff_t(std::min(others.size(), most_beside)));
        for (const AttributeOutcome& o : std::span(outcomes).subspan(1))
            if (o.has_cause() && diagnosis.further.size() < most_others_wrong)
                diagnosis.further.push_back(o.readings.front());
        return diagnosis;
    }

  private:
    AttributeOutcome outcome_of(Attribute attribute) const {
        Pixels wrong, right = asked_agreeing_;
        for (const PixelCoord& pixel : asked_wrong_)
            (check_.are_admissible(pixel, check_.values_at(pixel, attribute)) ? right : wrong)
                .push_back(pixel);
        AttributeOutcome outcome{.wrong = wrong.size(), .readings = {}};
        if (wrong.empty()) return outcome;
        for (const AttributeReading& reading : readings_of(attribute, input_.scene, input_.view)) {
            if (admitted(evenly(wrong, first_pixels), attribute, reading) == 0) continue;
            const auto& [name, description, look_at] = reading.cause;
            Explanation e{.name = name, .description = description, .look_at = look_at};
            e.asked = wrong.size();
            e.explained = admitted(wrong, attribute, reading);
            e.checked = right.size();
            e.contradicted = e.checked - admitted(right, attribute, reading);
            tell_bits(e, attribute);
            outcome.readings.push_back(e);
        }
        std::ranges::stable_sort(outcome.readings, std::greater{}, [](const Explanation& e) {
            return std::pair{AttributeOutcome::explains_all(e), e.explained};
        });
        return outcome;
    }

    std::uint64_t admitted(const Pixels& pixels, Attribute attribute, const AttributeReading& reading) const {
        return std::uint64_t(std::ranges::count_if(pixels, [&](const PixelCoord& pixel) {
            const auto id = std::uint32_t(input_.candidate.frame.primitive.at(pixel.x, pixel.y));
            const auto read =
                reading.read({input_.scene, input_.view, id}, check_.values_at(pixel, attribute));
            return read && check_.are_admissible(pixel, *read);
        }));
    }

    /// Without it, each wrong pixel tells where it is and its values, 32 bits each.
    void tell_bits(Explanation& e, Attribute attribute) const {
        const double count = double(wrong_.size()) * double(e.asked) / double(asked_wrong_.size());
        const double values =
            double(std::ranges::count(attribute_channels, attribute, &AttributeChannel::attribute));
        const double all_bits =
            bits_of_choice(count, double(input_.candidate.frame.size().pixel_count())) + 32 * values * count;
        e.saved_share = explained_share(e);
        e.saved_bits = all_bits * e.saved_share;
    }

    const DiagnosisInput& input_;
    AttributeCheck check_;
    Pixels wrong_, asked_wrong_, asked_agreeing_;
};

}  // namespace

std::optional<Diagnosis> diagnose_attributes(const DiagnosisInput& input, const Verdict& verdict) {
    return AttributeDiagnoser(input, verdict).run();
}

}  // namespace zproof
