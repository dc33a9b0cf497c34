// The commands that look at renderers and scenes without judging a run: render, measure, fit, selfcheck,
// conformance, contract-check, selftest, init, list, scenes.
#include "cli/command_line/branches.h"
#include "cli/command_line/options.h"
#include "cli/commands.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr const char* measure_remark =
    "\nExit status: 0 everything as declared, 1 worse than declared, 2 no such renderer, "
    "3 a picture that does not come.";

constexpr const char* fit_remark =
    "\nExit status: 0 every pixel is explained, 1 pixels are left out, 2 to 4 as for run.";

constexpr const char* selfcheck_remark =
    "\nExit status: 0 no frame contradicts another, 1 a frame is wrong, 2 to 4 as for run.";

constexpr const char* contract_remark =
    "\nThree small scenes. Exit status: 0 the contract is kept, 1 a frame is wrong, 3 no frame came.";

const std::map<std::string, InitArguments::Language> languages{{"c++", InitArguments::Language::cpp},
                                                               {"opengl", InitArguments::Language::opengl},
                                                               {"python", InitArguments::Language::python}};

/// SCENE; take_renderer() takes a renderer from among them.
void add_scenes_or_renderer(CLI::App& app, std::vector<std::string>& scenes) {
    app.add_option(
        "SCENE", scenes,
        std::string{"'suite', a folder, a renderer, or a "} + scene_words + "; none: the whole suite");
}

CLI::App& add_random_scenes(CLI::App& scenes, RandomScenesArguments& drawn) {
    CLI::App& app = *scenes.add_subcommand("random", "write random scenes as .glb and .view.json");
    app.add_option("--count", drawn.random.count, "numbers from 0 on")
        ->check(CLI::Range(std::uint64_t{1}, most_random_scenes))
        ->capture_default_str();
    add_random_choice(app, drawn.random);
    add_common(app, drawn.common, "folder for the files");
    return app;
}

}  // namespace

Branch add_render(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("render", "write a renderer's frames as EXR and PNG, not judged");
    app.add_option("SCENE", words.render.scene, scene_words)->required();
    add_models(app, words.render.models);
    add_common(app, words.render.common, "folder for the frames");
    add_renderer_options(app, words.renderers);
    app.add_option("--filter", words.renderers.filter,
                   "also write textures as this method reads them: NAME[:key=value]...")
        ->type_name("METHOD");
    app.add_flag("--attributes", words.render.attributes,
                 "also write barycentrics, uv, normals and positions, as our rasterizer interpolates them");
    add_render_settings(app, words.render.settings);
    add_samples(app, words.render.settings);
    app.footer("\nFilters: zproof filters list. Their settings: zproof filters run --help.");
    return {&app, [&words] {
                words.render.renderer = candidate_of(words.renderers);
                words.render.filter = words.renderers.filter;
                return command_of(words.render, "cannot render");
            }};
}

Branch add_measure(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand(
        "measure", "what a renderer really does: sub-pixel grid, fill side, depth steps, watertightness");
    auto* renderer = app.add_option("RENDERER", words.renderers.renderer,
                                    "a name, or 'CMD {scene} {camera} {width} {height} {out}'");
    auto* named = app.add_option("--renderer", words.renderers.renderer, "the same")->excludes(renderer);
    add_common(app, words.measure.common);
    add_precision_options(app, words.renderers);
    add_keep_input(app, words.renderers);
    add_isa(app);
    app.add_option("--emit", words.measure.emit,
                   "also write what was measured as a precision file (.json), for --precision");
    app.add_flag_callback(
        "--json", [&words] { words.measure.format = MeasurementFormat::json; },
        "print JSON instead of a table");
    app.footer(measure_remark);
    return {&app, [&words, renderer, named] {
                if (renderer->count() + named->count() == 0)
                    throw UsageError{"RENDERER is required (see: zproof measure --help)"};
                words.measure.renderer = candidate_of(words.renderers);
                return command_of(words.measure, "cannot measure");
            }};
}

Branch add_fit(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand(
        "fit", "the least promise that explains every pixel, whatever the renderer declares");
    FitArguments& fit = words.fit;
    add_scenes_or_renderer(app, fit.scenes);
    app.add_option("--view", fit.view, "name of the view; default: all")->type_name("VIEW");
    app.add_option("--renderer", words.renderers.renderer,
                   "whose frames: zproof, embree, opengl, povray, vulkan, or 'CMD {scene} {camera} {width} "
                   "{height} {out}'")
        ->type_name("RENDERER")
        ->capture_default_str();
    add_time_limit(app, words.renderers);
    add_device(app, words.renderers);
    app.add_option("--candidate", words.renderers.candidate, "a stored frame in the renderer's place");
    add_common(app, fit.common, "folder for tables, chart, fit.json and precision.json");
    add_render_settings(app, fit.settings);
    app.footer(fit_remark);
    return {&app, [&words] {
                take_renderer(words.fit.scenes, words.renderers);
                words.fit.renderer = candidate_of(words.renderers);
                return command_of(words.fit, "cannot fit");
            }};
}

Branch add_selfcheck(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand(
        "selfcheck", "is a renderer at one with itself? the same pictures told in other ways, no reference");
    SelfcheckArguments& selfcheck = words.selfcheck;
    add_scenes_or_renderer(app, selfcheck.scenes);
    add_renderer_options(app, words.renderers);
    add_common(app, selfcheck.common);
    add_render_settings(app, selfcheck.settings);
    app.footer(selfcheck_remark);
    return {&app, [&words] {
                take_renderer(words.selfcheck.scenes, words.renderers);
                words.selfcheck.renderer = candidate_of(words.renderers);
                return command_of(words.selfcheck, "cannot check the renderer");
            }};
}

Branch add_conformance(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand(
        "conformance", "does a device keep what it promises? suite, random scenes and measure on one page");
    app.add_option("DEVICE", words.renderers.renderer,
                   "vulkan, opengl, another name, or 'CMD {scene} {camera} {width} {height} {out}'")
        ->required()
        ->type_name("RENDERER");
    app.add_option("--random", words.conformance.random.count, "so many random scenes")
        ->check(CLI::Range(std::uint64_t{1}, most_random_scenes))
        ->capture_default_str();
    add_precision_options(app, words.renderers);
    add_keep_input(app, words.renderers);
    add_report(app, words.conformance.report);
    add_evidence(app, words.conformance.report);
    add_isa(app);
    return {&app, [&words] {
                words.conformance.renderer = candidate_of(words.renderers);
                return command_of(words.conformance, "cannot judge");
            }};
}

Branch add_contract_check(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand(
        "contract-check", "does a program keep the renderer contract? three small scenes, answers in words");
    app.add_option("COMMAND", words.renderers.renderer,
                   "with {scene}, {camera}, {width}, {height} and {out} in it")
        ->required();
    add_precision_options(app, words.renderers);
    add_keep_input(app, words.renderers);
    add_ids_option(app, words.renderers);
    add_common(app, words.contract_check.common);
    add_isa(app);
    app.footer(contract_remark);
    return {&app, [&words] {
                words.contract_check.renderer = candidate_of(words.renderers);
                return command_of(words.contract_check, "cannot check the contract");
            }};
}

Branch add_selftest(CLI::App& parent, CommandWords& words) {
    CLI::App& app =
        *parent.add_subcommand("selftest", "see the gate fail: inject known faults into good frames");
    add_common(app, words.selftest.common);
    add_isa(app);
    return {&app, [&words] { return command_of(words.selftest, "cannot test the gate"); }};
}

Branch add_init(CLI::App& parent, CommandWords& words) {
    CLI::App& app =
        *parent.add_subcommand("init", "files to begin with: a renderer that is proven, and its gate");
    add_choice(app, "LANGUAGE", words.init.language, languages)
        ->default_str("python")
        ->description("what the renderer is written in; opengl: C++, without a window");
    add_common(app, words.init.common, "folder for the files");
    return {&app, [&words] { return command_of(words.init, "cannot begin"); }};
}

Branch add_list(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("list", "the built-in suite: each scene with its reason");
    add_common(app, words.list.common);
    app.add_flag_callback(
        "--names", [&words] { words.list.detail = ListArguments::Detail::names; },
        "the names alone, one on a line");
    return {&app, [&words] { return command_of(words.list, "cannot list the suite"); }};
}

Branch add_scenes(CLI::App& parent, CommandWords& words) {
    CLI::App& app = *parent.add_subcommand("scenes", "the built-in suite, or random scenes, as files");
    CLI::App& generate = *app.add_subcommand("generate", "write suite scenes as .glb and .view.json");
    app.require_subcommand(0, 1);
    generate.add_option("NAME", words.generate.names, "suite scenes (zproof list); none: all");
    add_common(generate, words.generate.common, "folder for the files");
    CLI::App& drawn = add_random_scenes(app, words.random_scenes);
    return {&app, [&words, &generate, &drawn]() -> Command {
                if (generate.parsed()) return command_of(words.generate, "cannot generate");
                if (drawn.parsed()) return command_of(words.random_scenes, "cannot write the scenes");
                throw UsageError{"scenes: 'generate' or 'random' expected (see: zproof scenes --help)"};
            }};
}

}  // namespace zproof
