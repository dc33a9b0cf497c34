#include "cli/oracle_answers.h"

#include "compare/judge.h"
#include "oracle/oracle_error.h"
#include "reports/wording.h"

namespace zproof {
namespace {

OpenedOracle absent(const OracleChoice& choice, const std::string& why) {
    return {.choice = choice, .absent = why, .renderer = {}};
}

OpenedOracle open_oracles(const OracleChoice& choice, const Scene& scene) {
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

OracleAnswer silent(const OpenedOracle& oracle, const std::string& why) {
    return {.result = {.name = name_of(oracle.choice.renderer), .absent = why, .worst = {}},
            .frame = {},
            .classes = {}};
}

}  // namespace

std::vector<OpenedOracle> open_oracles(const std::vector<OracleChoice>& choices, const Scene& scene) {
    std::vector<OpenedOracle> oracles;
    for (const OracleChoice& choice : choices) oracles.push_back(open_oracles(choice, scene));
    return oracles;
}

OracleAnswer ask_oracle(const OpenedOracle& oracle, const ViewContext& context,
                        const RenderedFrame& reference) {
    if (!oracle.absent.empty()) return silent(oracle, oracle.absent);
    try {
        auto frame = std::make_unique<const Frame>(oracle.renderer.render(context.view));
        const Verdict verdict =
            judge(context.scene, context.view, {*frame, oracle.renderer.precision}, reference);
        return {to_oracle_result(context, oracle.choice.renderer, verdict), std::move(frame),
                verdict.classes};
    } catch (const OracleError& e) {
        return silent(oracle, e.what());
    }
}

std::string missing_oracle(const std::vector<OpenedOracle>& oracles,
                           const std::vector<OracleResult>& results) {
    for (std::size_t i = 0; i < oracles.size(); ++i)
        if (oracles[i].choice.need == OracleChoice::Need::required && !results[i].absent.empty())
            return results[i].name + " was required and was not compared: " + results[i].absent;
    return "";
}

}  // namespace zproof
