#include "cli/witness_hearing.h"

#include "compare/judge.h"
#include "oracle/oracle_error.h"
#include "reports/wording.h"

namespace zproof {
namespace {

SummonedWitness absent(const WitnessChoice& choice, const std::string& why) {
    return {.choice = choice, .absent = why, .renderer = {}};
}

SummonedWitness summon(const WitnessChoice& choice, const Scene& scene) {
    if (const std::string why = absence_of(choice.renderer); !why.empty()) return absent(choice, why);
    if (scene.triangles.size() > choice.most_triangles)
        return absent(choice, "asked only about scenes of up to " + grouped(choice.most_triangles) +
                                  " triangles; --oracle " + name_of(choice.renderer) + " asks it anyway");
    try {
        return {.choice = choice, .absent = "", .renderer = open(choice.renderer, scene)};
    } catch (const OracleError& e) {
        return absent(choice, e.what());
    }
}

Statement silent(const SummonedWitness& witness, const std::string& why) {
    return {.result = {.name = name_of(witness.choice.renderer), .absent = why, .worst = {}},
            .frame = {},
            .classes = {}};
}

}  // namespace

std::vector<SummonedWitness> summon(const std::vector<WitnessChoice>& choices, const Scene& scene) {
    std::vector<SummonedWitness> witnesses;
    for (const WitnessChoice& choice : choices) witnesses.push_back(summon(choice, scene));
    return witnesses;
}

Statement hear(const SummonedWitness& witness, const Docket& docket, const RenderedFrame& reference) {
    if (!witness.absent.empty()) return silent(witness, witness.absent);
    try {
        auto frame = std::make_unique<const Frame>(witness.renderer.render(docket.view));
        const Verdict verdict =
            judge(docket.scene, docket.view, {*frame, witness.renderer.precision}, reference);
        return {to_witness_result(docket, witness.choice.renderer, verdict), std::move(frame),
                verdict.classes};
    } catch (const OracleError& e) {
        return silent(witness, e.what());
    }
}

std::string missing_witness(const std::vector<SummonedWitness>& witnesses,
                            const std::vector<WitnessResult>& results) {
    for (std::size_t i = 0; i < witnesses.size(); ++i)
        if (witnesses[i].choice.need == WitnessChoice::Need::required && !results[i].absent.empty())
            return results[i].name + " was required and was not heard: " + results[i].absent;
    return "";
}

}  // namespace zproof
