#include "cli/oracle_answers.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cli/plan/expected_seconds.h"
#include "compare/judge.h"
#include "oracle/oracle_error.h"

namespace zproof {
namespace {

OpenedOracle absent(const OracleChoice& choice, const std::string& why) {
    return {.choice = choice, .absent = why, .renderer = {}};
}

/// Why an oracle that nobody named is not asked; empty: it is.
std::string why_not_asked(const OracleChoice& choice, const Renderer& oracle, const Scene& scene,
                          const std::vector<View>& views) {
    if (choice.pixels != OracleChoice::Pixels::sample_if_cheap || !oracle.sample_price_s) return "";
    const PlannedScene rest = expected_of("", scene, views, 1);
    double left_s = std::accumulate(rest.view_s.begin(), rest.view_s.end(), rest.setup_s);
    for (const View& view : views)
        if ((left_s -= oracle.sample_price_s(view, left_s)) < 0)
            return "not asked, since it takes longer than all the rest; --oracle " + oracle.name +
                   ":sample asks it";
    return "";
}

OpenedOracle open_oracle(const OracleChoice& choice, const Scene& scene, const std::vector<View>& views) {
    if (const std::string why = absence_of(choice.renderer); !why.empty()) return absent(choice, why);
    try {
        OpenedOracle oracle{.choice = choice, .absent = "", .renderer = open(choice.renderer, scene)};
        if (const std::string why = why_not_asked(choice, oracle.renderer, scene, views); !why.empty())
            return absent(choice, why);
        if (choice.pixels != OracleChoice::Pixels::all && oracle.renderer.begin_sample)
            oracle.samples = std::make_unique<SampledViews>(oracle.renderer, views);
        return oracle;
    } catch (const OracleError& e) {
        return absent(choice, e.what());
    }
}

OracleAnswer silent(const OpenedOracle& oracle, const std::string& why) {
    return {.result = {.name = name_of(oracle.choice.renderer), .absent = why, .worst = {}}};
}

OracleAnswer answer_of(const OpenedOracle& oracle, const ViewContext& context,
                       std::unique_ptr<const Frame> frame, Verdict verdict) {
    return {.result = to_oracle_result(context, oracle.choice.renderer, verdict),
            .frame = std::move(frame),
            .classes = std::move(verdict.classes)};
}

OracleAnswer judged(const OpenedOracle& oracle, const ViewContext& context, const RenderedFrame& reference) {
    auto frame = std::make_unique<const Frame>(oracle.renderer.render(context.view));
    Verdict verdict = judge(context.scene, context.view, {*frame, oracle.renderer.precision}, reference);
    return answer_of(oracle, context, std::move(frame), std::move(verdict));
}

/// Findings are at cells of the lattice; they move to the image's pixels.
void move_to_image(const PixelLattice& pixels, std::vector<Finding>& findings) {
    for (Finding& finding : findings) {
        finding.x = pixels.first_x + pixels.stride * finding.x;
        finding.y = pixels.first_y + pixels.stride * finding.y;
        finding.eps_px *= pixels.stride;
    }
}

/// The sample is judged as a view of its own.
OracleAnswer judged_sample(const OpenedOracle& oracle, const ViewContext& context, std::size_t place,
                           const RenderedFrame& reference) {
    SampledFrame sampled = oracle.samples->take(place);
    const PixelLattice& pixels = sampled.pixels;
    auto frame = std::make_unique<const Frame>(std::move(sampled.frame));
    Verdict verdict = judge(context.scene, view_of(pixels, context.view), {*frame, oracle.renderer.precision},
                            {frame_at(pixels, reference.frame), reference.precision});
    move_to_image(pixels, verdict.findings);
    const std::uint64_t count = frame->size().pixel_count();
    OracleAnswer answer = answer_of(oracle, context, std::move(frame), std::move(verdict));
    if (pixels.stride == 1) return answer;  // that is all of them
    answer.pixels = pixels;
    answer.result.sample = SampledPixels{pixels.stride, pixels.first_x,     pixels.first_y,
                                         count,         SampledViews::seed, sampled.fewer_because};
    return answer;
}

}  // namespace

std::vector<OpenedOracle> open_oracles(const std::vector<OracleChoice>& choices, const Scene& scene,
                                       const std::vector<View>& views) {
    std::vector<OpenedOracle> oracles;
    for (const OracleChoice& choice : choices) oracles.push_back(open_oracle(choice, scene, views));
    return oracles;
}

OracleAnswer ask_oracle(const OpenedOracle& oracle, const ViewContext& context, std::size_t place,
                        const RenderedFrame& reference) {
    if (!oracle.absent.empty()) return silent(oracle, oracle.absent);
    try {
        return oracle.samples ? judged_sample(oracle, context, place, reference)
                              : judged(oracle, context, reference);
    } catch (const OracleError& e) {
        return silent(oracle, e.what());
    }
}

IdAgreement id_agreement_of(const Frame& candidate, const Frame& reference,
                            const std::vector<OracleAnswer>& answers) {
    const auto sampled =
        std::ranges::find_if(answers, [](const OracleAnswer& a) { return a.pixels.has_value(); });
    std::vector<Frame> some;  // where all of the view was asked about, and a sample is compared
    some.reserve(answers.size() + 2);
    std::vector<const Frame*> frames;
    const auto add = [&](const Frame& frame, bool is_sample) {
        if (sampled == answers.end() || is_sample) return frames.push_back(&frame);
        frames.push_back(&some.emplace_back(frame_at(*sampled->pixels, frame)));
    };
    add(candidate, false);
    add(reference, false);
    for (const OracleAnswer& answer : answers)
        if (answer.frame) add(*answer.frame, answer.pixels.has_value());
    return count_id_agreement(frames);
}

std::string missing_oracle(const std::vector<OpenedOracle>& oracles,
                           const std::vector<OracleResult>& results) {
    for (std::size_t i = 0; i < oracles.size(); ++i)
        if (oracles[i].choice.need == OracleChoice::Need::required && !results[i].absent.empty())
            return results[i].name + " was required and was not compared: " + results[i].absent;
    return "";
}

}  // namespace zproof
