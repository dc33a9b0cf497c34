#include <array>
#include <iostream>
#include <map>
#include <optional>

#include "cli/commands.h"
#include "cli/renderers/roster.h"
#include "cli/threads.h"
#include "compare/diagnosis.h"
#include "compare/explain.h"
#include "oracle/oracle_error.h"
#include "reports/diagnosis_words.h"
#include "reports/wording.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

/// A perspective view from inside with a triangle at every pixel, windows that are not centred, and a
/// projection whose lines of sight do not run along the view axis: together they tell apart what a renderer
/// can mistake in the contract. The picture is not square, so that width and height cannot be exchanged.
constexpr std::array conversation{"room", "off_axis", "oblique"};
constexpr Resolution picture_size{.width = 160, .height = 100};

/// What came of the conversation so far; the worst of it is the exit status.
struct Minutes {
    int pictures = 0, wrong = 0, missing = 0;
    std::map<std::string, int> causes;  ///< of how many wrong pictures each is the likely one
};

std::string in_words(const Scene& scene, const Verdict& verdict, const std::optional<Diagnosis>& diagnosis) {
    std::string text = counted(defect_count(verdict), "pixel") + " wrong";
    if (diagnosis) text += "\n    " + zproof::in_words(*diagnosis);
    for (const Finding& finding : verdict.findings)
        if (!passes(finding.verdict)) return text + "\n    first: " + zproof::in_words(scene, finding);
    return text;
}

void talk_about(const Scene& scene, const View& view, const Renderer& renderer, Minutes& minutes) {
    const Renderer embree = open({.who = BuiltIn{"embree"}, .precision_word = {}}, scene);
    const Frame candidate = renderer.render(view), reference = embree.render(view);
    const Testimony ours{candidate, renderer.precision}, theirs{reference, embree.precision};
    const Verdict verdict = judge(scene, view, ours, theirs);
    if (defect_count(verdict) == 0) {
        std::cout << "kept\n";
        return;
    }
    const std::optional<Diagnosis> diagnosis = diagnose(scene, view, ours, theirs, verdict);
    ++minutes.wrong;
    if (diagnosis && diagnosis->cause) ++minutes.causes[diagnosis->cause->name];
    std::cout << in_words(scene, verdict, diagnosis) << "\n";
}

void talk_about(const std::string& name, const RendererChoice& choice, Minutes& minutes) {
    const Loaded loaded = generate_suite_scene(name, picture_size.width, picture_size.height);
    const Renderer renderer = open(choice, loaded.scene);
    for (const View& view : loaded.views) {
        ++minutes.pictures;
        std::cout << name << "/" << view.name << ": " << std::flush;
        try {
            talk_about(loaded.scene, view, renderer, minutes);
        } catch (const OracleError& e) {
            ++minutes.missing;
            std::cout << "no frame\n    " << e.what() << "\n";
        }
    }
}

ExitCode conclusion(const Minutes& minutes) {
    std::cout << "\n";
    for (const auto& [cause, count] : minutes.causes)
        std::cout << "likely cause: " << cause << " (" << counted(std::uint64_t(count), "picture") << ")\n";
    std::cout << "\n"
              << counted(std::uint64_t(minutes.pictures), "picture") << ": " << minutes.wrong << " wrong, "
              << minutes.missing << " missing. ";
    if (minutes.missing > 0) {
        std::cout << "The contract is not kept; docs/renderer-contract.md says what a program must do.\n";
        return ExitCode::cannot_judge;
    }
    std::cout << (minutes.wrong == 0 ? "The contract is kept.\n"
                                     : "The program answers, and not what it sees.\n");
    return minutes.wrong == 0 ? ExitCode::proven : ExitCode::defect;
}

}  // namespace

ExitCode execute(const ContractCheckArguments& arguments) {
    Minutes minutes;
    on_threads(arguments.threads, [&] {
        for (const char* name : conversation) talk_about(name, arguments.renderer, minutes);
    });
    return conclusion(minutes);
}

}  // namespace zproof
