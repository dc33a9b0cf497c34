#include <array>
#include <iostream>
#include <map>
#include <optional>

#include "cli/commands.h"
#include "cli/labelled_candidate.h"
#include "compare/diagnosis/diagnosis.h"
#include "compare/explanation/explain.h"
#include "oracle/oracle_error.h"
#include "program/common_arguments.h"
#include "program/interrupt.h"
#include "program/work_progress.h"
#include "renderers/registry.h"
#include "reports/diagnosis_words.h"
#include "reports/wording.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

/// A perspective view from inside with a triangle at every pixel, windows that are not centred, and a
/// projection whose view rays do not run along the view axis: together they tell apart what a renderer
/// can mistake in the contract. The picture is not square, so that width and height cannot be exchanged.
constexpr std::array contract_scenes{"room", "off_axis", "oblique"};
/// A parallel view may begin behind its eye, which many renderers forget.
constexpr const char* scene_around_the_eye = "orthographic";
constexpr Resolution picture_size{.width = 160, .height = 100};

/// What came of the contract's scenes so far; the worst of it is the exit status.
struct ContractTally {
    int expected = 0;  ///< pictures, unless we are interrupted
    int pictures = 0, wrong = 0, missing = 0;
    std::map<std::string, int> causes;  ///< of how many wrong pictures each is the likely one
};

std::string in_words(const Scene& scene, const CandidateFrame& candidate, const Verdict& verdict,
                     const std::optional<Diagnosis>& diagnosis) {
    std::string text = counted(defect_count(verdict), "pixel") + " wrong";
    if (diagnosis) text += "\n    " + zproof::in_words(*diagnosis);
    for (const Finding& finding : verdict.findings)
        if (!passes(finding.verdict))
            return text + "\n    first: pixel " + std::to_string(finding.x) + ", " +
                   std::to_string(finding.y) + ": " + zproof::in_words(scene, finding) +
                   candidate.label_sentence(finding.x, finding.y);
    return text;
}

/// Would the frame be right if nothing were asked of it behind the eye?
bool is_right_before_the_eye(const Scene& scene, const View& view, const RenderedFrame& candidate,
                             const Renderer& embree) {
    if (!(view.camera.near_depth < 0)) return false;
    View ahead = view;
    ahead.camera.near_depth = 0;
    return defect_count(judge(scene, ahead, candidate, {embree.render(ahead), embree.precision})) == 0;
}

/// One picture: what came of it, in words that end a line.
std::string judged(const Scene& scene, const View& view, const Renderer& renderer, ContractTally& tally) {
    const Renderer embree = open({.who = BuiltIn{"embree"}, .precision_word = {}}, scene);
    const Frame reference = embree.render(view);
    const CandidateFrame candidate =
        candidate_frame(scene, view, renderer, renderer.render(view), {reference, embree.precision});
    const RenderedFrame ours{candidate.frame, renderer.precision}, theirs{reference, embree.precision};
    const Verdict verdict = judge(scene, view, ours, theirs);
    if (defect_count(verdict) == 0) return "kept\n";
    ++tally.wrong;
    if (is_right_before_the_eye(scene, view, ours, embree)) {
        ++tally.causes["what lies behind the eye of a parallel view is not drawn"];
        return counted(defect_count(verdict), "pixel") +
               " wrong\n    near lies behind the eye of this parallel view, and what lies there is missing; "
               "a "
               "rasterizer that means\n    to leave it out declares \"nothing_behind_the_eye\": true\n";
    }
    const std::optional<Diagnosis> diagnosis =
        diagnose(scene, view, ours, theirs, verdict, {candidate.said(), renderer.convention});
    if (diagnosis && diagnosis->cause) ++tally.causes[diagnosis->cause->name];
    return in_words(scene, candidate, verdict, diagnosis) + "\n";
}

/// Judges the frame, or says why none came.
std::string answer_of(const Scene& scene, const View& view, const Renderer& renderer, ContractTally& tally) {
    ++tally.pictures;
    try {
        return judged(scene, view, renderer, tally);
    } catch (const OracleError& e) {
        ++tally.missing;
        return std::string{"no frame\n    "} + e.what() + "\n";
    }
}

void check_views(const Loaded& loaded, const ContractCheckArguments& arguments, WorkProgress& progress,
                 ContractTally& tally) {
    const Renderer renderer = open(arguments.renderer, loaded.scene);
    for (const View& view : loaded.views) {
        if (interrupted()) return;
        const std::string picture = loaded.scene.name + "/" + view.name;
        progress.begin(picture);
        const std::string answer = answer_of(loaded.scene, view, renderer, tally);
        if (!arguments.common.is_quiet()) progress.say(std::cout, picture + ": " + answer);
    }
}

/// The last of a scene's parallel views, with its eye moved on to the middle of what it sees.
Loaded around_the_eye() {
    Loaded loaded = generate_suite_scene(scene_around_the_eye, picture_size.width, picture_size.height);
    View view = loaded.views.back();
    view.name = "behind-the-eye";
    Camera& c = view.camera;
    const float middle = 96;  // the town lies at depths from 60 to 150
    c.eye_world -= middle * glm::vec3(c.back);
    c.near_depth -= middle;
    c.far_depth -= middle;
    loaded.views = {view};
    return loaded;
}

std::vector<Loaded> load_contract_scenes() {
    std::vector<Loaded> scenes;
    for (const char* name : contract_scenes)
        scenes.push_back(generate_suite_scene(name, picture_size.width, picture_size.height));
    scenes.push_back(around_the_eye());
    return scenes;
}

int views_of(const std::vector<Loaded>& scenes) {
    int views = 0;
    for (const Loaded& loaded : scenes) views += int(loaded.views.size());
    return views;
}

void tell_causes(const ContractTally& tally) {
    std::cout << "\n";
    for (const auto& [cause, count] : tally.causes)
        std::cout << "likely cause: " << cause << " (" << counted(std::uint64_t(count), "picture") << ")\n";
    std::cout << "\n";
}

ExitCode conclusion(const ContractTally& tally, const std::string& promise) {
    std::cout << counted(std::uint64_t(tally.pictures), "picture") << ": " << tally.wrong << " wrong, "
              << tally.missing << " missing. ";
    if (tally.pictures < tally.expected) {
        std::cout << "Not all were asked for.\n" << std::flush;
        return say_interrupted({std::size_t(tally.pictures), std::size_t(tally.expected)}, "picture",
                               "asked for and judged");
    }
    if (tally.missing > 0) {
        std::cout << "The contract is not kept; docs/renderer-contract.md says what a program must do.\n";
        return ExitCode::cannot_judge;
    }
    if (tally.wrong == 0) {
        std::cout << "The contract is kept.\n";
        return ExitCode::proven;
    }
    std::cout << "The program answers, and not what it sees"
              << (promise.empty()
                      ? ", or its arithmetic is not what is taken for granted: --precision opengl "
                        "or another (docs/presets.md).\n"
                      : ".\n");
    return ExitCode::defect;
}

}  // namespace

ExitCode execute(const ContractCheckArguments& arguments) {
    require_program(arguments.renderer);
    const std::vector<Loaded> scenes = load_contract_scenes();
    note_interrupts();
    ContractTally tally{.expected = views_of(scenes), .causes = {}};
    {
        WorkProgress progress{std::cerr, progress_beside_lines(arguments.common), double(tally.expected)};
        on_threads(arguments.common.threads, [&] {
            for (const Loaded& loaded : scenes) check_views(loaded, arguments, progress, tally);
        });
    }
    if (!arguments.common.is_quiet()) tell_causes(tally);
    return conclusion(tally, arguments.renderer.precision_word);
}

}  // namespace zproof
