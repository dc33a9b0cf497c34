#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "cli/commands.h"
#include "cli/judgement.h"
#include "cli/measurement_run.h"
#include "cli/outcome_code.h"
#include "cli/selected_scenes.h"
#include "oracle/scratch_folder.h"
#include "oracle/subprocess.h"
#include "oracle/vulkan.h"
#include "program/companion.h"
#include "program/folder_names.h"
#include "program/interrupt.h"
#include "renderers/registry.h"
#include "reports/conformance_report.h"

namespace zproof {
namespace {

using Words = std::vector<std::string>;

struct AskedFilter {
    std::string method;          ///< as `zproof filters run` names the device's sampler
    int weight_bits, lod_bits;   ///< of its promise
    std::string other_device{};  ///< which it would ask in place of the one that is meant; empty: none
};

std::optional<AskedFilter> trilinear_of(const RendererChoice& renderer) {
    const auto* known = std::get_if<BuiltIn>(&renderer.who);
    if (known != nullptr && known->name == "opengl") return AskedFilter{"opengl-trilinear", 8, 8};
    if (known == nullptr || known->name != "vulkan") return std::nullopt;
    const oracle::VulkanDevice device = oracle::vulkan_devices().at(0);
    const bool is_meant = device.version.find(known->vulkan.device) != std::string::npos;
    return AskedFilter{"vulkan-trilinear:mip=box", device.subtexel_bits, device.mipmap_bits,
                       is_meant ? "" : device.version};
}

/// What zproof-filters prints. Throws std::runtime_error, in its words, where it did not do so much.
std::string told_by_filters(const Words& words) {
    const auto program = program_of(*companion_named("filters"));
    if (!program) throw std::runtime_error{"zproof-filters is not beside zproof"};
    oracle::Command command{.arguments = {program->string()}};
    command.arguments.insert(command.arguments.end(), words.begin(), words.end());
    command.kept_bytes = std::size_t{1} << 20;
    const oracle::Outcome outcome = oracle::run(command);
    if (interrupted()) throw std::runtime_error{"interrupted"};
    if (outcome.output.empty() || outcome.ending != oracle::Ending::exited)
        throw std::runtime_error{oracle::in_words(outcome, command.time_limit) + "; " + last_output(outcome)};
    return outcome.output;
}

/// The picture of the scene `worked` by the device, judged by the definition.
void judge(TexturePromise& promise, const AskedFilter& asked, const std::string& precision, int threads) {
    const Words view{"worked", "--view", "phi-0", "--threads", std::to_string(threads)};
    const auto told = [&](Words words) {
        words.insert(words.end(), view.begin(), view.end());
        return told_by_filters(words);
    };
    const oracle::ScratchFolder folder;
    const std::filesystem::path study = folder.path() / "study";
    told({"run", "--methods", asked.method, "--flicker", "0", "--quiet", "--out", study.string()});
    const auto picture = study / "pictures" / "worked-phi-0" / (safe_name(asked.method) + ".exr");
    read_filter_check(promise, told({"check", "trilinear-gl:mip=box", "--json", "--picture", picture.string(),
                                     "--precision", precision}));
}

/// The texture filters of a device, held to their definition by zproof-filters (docs/conformance.md): one for
/// each that has a definition; none where zproof asks no textures of the renderer.
std::vector<TexturePromise> texture_promises(const RendererChoice& renderer, const CommonArguments& common) {
    const std::optional<AskedFilter> asked = trilinear_of(renderer);
    if (!asked) return {};
    const std::string weights = std::to_string(asked->weight_bits), lod = std::to_string(asked->lod_bits);
    TexturePromise promise{.filter = "trilinear",
                           .promise = "trilinear-gl, weights of " + weights + " bits, LOD of " + lod};
    try {
        if (!asked->other_device.empty())
            throw std::runtime_error{"zproof-filters would ask " + asked->other_device};
        judge(promise, *asked,
              "vulkan-min,arithmetic_bits=53,weight_bits=" + weights + ",tap_bits=" + weights +
                  ",lod_bits=" + lod,
              common.threads);
    } catch (const std::runtime_error& e) {
        promise.refusal = e.what();
    }
    return {promise};
}

/// The suite as a quick run has it, then the random scenes.
RunArguments run_of(const RandomChoice& random) {
    RunArguments run;
    run.size = RunSize::quick;
    run.scenes = random.words();
    run.scenes.insert(run.scenes.begin(), "suite");
    run.settings.resolution = resolution_for(run.size, run.settings.resolution);
    return run;
}

/// Measures the device, or says why that cannot be.
Foreword foreword_of(const ConformanceArguments& arguments, const Results& results) {
    MeasuredPromises promises;
    ExitCode code = ExitCode::proven;
    try {
        const measure::Renderer renderer = measured_renderer(arguments.renderer);
        const auto [measurement, instruments] = measured(renderer, arguments.report.common);
        promises.findings = measure::findings(measurement, renderer.declared);
        if (measure::is_worse(promises.findings)) code = ExitCode::defect;
        if (instruments.done < instruments.all) {
            promises.refusal = "interrupted";
            code = say_interrupted(instruments, "instrument", "read");
        }
    } catch (const std::runtime_error& e) {
        promises.refusal = e.what();
        code = ExitCode::cannot_judge;
    }
    if (!interrupted()) promises.textures = texture_promises(arguments.renderer, arguments.report.common);
    for (const TexturePromise& texture : promises.textures)
        code = worst_of({code, !texture.refusal.empty() ? ExitCode::cannot_judge
                               : texture.is_broken      ? ExitCode::defect
                                                        : ExitCode::proven});
    return {conformance_document(results, promises), "conformance.json", code};
}

}  // namespace

ExitCode execute(const ConformanceArguments& arguments) {
    require_program(arguments.renderer);
    const RunArguments run = run_of(arguments.random);
    SelectedScenes selected = selected_scenes(run);
    ChosenRenderers renderers;
    renderers.candidate = arguments.renderer;
    return judge_and_report(
        {.sources = std::move(selected.sources),
         .renderers = renderers,
         .settings = run.settings,
         .report = arguments.report,
         .selection = std::move(selected.selection),
         .foreword = [&](const Results& results) { return foreword_of(arguments, results); }});
}

}  // namespace zproof
