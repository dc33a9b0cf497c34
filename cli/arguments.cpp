#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <sstream>
#include <thread>

#include "cli/filters/command_line.h"
#include "cli/party_words.h"
#include "cli/study/command_line.h"
#include "cli/usage_error.h"
#include "cli/version.h"

namespace zproof {
namespace {

constexpr const char* examples = R"(Proves a z-buffer rasterizer right, pixel by pixel.

  zproof run                            judge the built-in suite, write zproof-out/
  zproof run models/ -o out             judge every .gltf, .glb and .view.json below models/
  zproof run --renderer './mine {scene} {camera} {width} {height} {out}' model.glb
                                        judge your own renderer (try contract-check first)
  zproof compare frame.exr model.glb    judge a frame that was rendered elsewhere
  zproof explain model.glb 812 344      tell the whole story of one pixel
  zproof measure zproof                 measure what a renderer really does
  zproof selftest                       see the gate fail: inject known faults into good frames
  zproof filters run worked -o study    how far texture filters are from the truth, and at what cost
  zproof study projection model.glb     every stage from world to pixel, against exact arithmetic

Exit status: 0 proven, 1 a defect, 2 usage, 3 unreadable input, 4 nothing judged, 70 internal error,
130 interrupted.)";

constexpr const char* scene_words = "suite scene, .gltf or .glb file, or view file (.json)";

const std::map<std::string, ColourWish> colour_wishes{
    {"auto", ColourWish::automatic}, {"always", ColourWish::always}, {"never", ColourWish::never}};
const std::map<std::string, ProgressStyle> progress_styles{{"auto", ProgressStyle::automatic},
                                                           {"bar", ProgressStyle::bar},
                                                           {"lines", ProgressStyle::lines},
                                                           {"none", ProgressStyle::none}};

/// Binds a word from a fixed list; the help shows the list, an unknown word is a usage error.
template <class T>
void add_choice(CLI::App& app, const std::string& option, T& value, const std::map<std::string, T>& choices) {
    std::vector<std::string> words;
    for (const auto& [word, meaning] : choices) words.push_back(word);
    app.add_option_function<std::string>(option, [&](const std::string& word) { value = choices.at(word); })
        ->check(CLI::IsMember(words))
        ->default_str("auto");
}

void add_threads(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "the verdict is the same for any number")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
}

void add_render_settings(CLI::App& app, RenderSettings& settings) {
    app.add_option("--width", settings.resolution.width, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    app.add_option("--height", settings.resolution.height, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    add_threads(app, settings.threads);
}

void add_report(CLI::App& app, ReportArguments& report) {
    app.add_option("-o,--out", report.out, "folder for the reports")->capture_default_str();
    add_choice(app, "--color", report.colour, colour_wishes);
    add_choice(app, "--progress", report.progress, progress_styles);
    app.add_flag_callback(
        "--pictures", [&report] { report.pictures = PictureWish::shaded; },
        "shaded colour pictures, beside those of witnesses that can paint");
    auto* quiet = app.add_flag_callback(
        "-q,--quiet",
        [&report] {
            report.detail = Detail::verdict;
            report.progress = ProgressStyle::none;
        },
        "print the verdict only");
    app.add_flag_callback(
           "--times", [&report] { report.detail = Detail::times; }, "also print where the time went")
        ->excludes(quiet);
}

void add_run(CLI::App& app, RunArguments& run, PartyWords& words) {
    app.add_option("SCENE", run.scenes,
                   std::string{"'suite', a folder, or a "} + scene_words + "; none: the whole suite");
    add_renderer_options(app, words);
    add_witness_options(app, words);
    add_render_settings(app, run.settings);
    add_report(app, run.report);
    app.callback([&] { run.parties = parties_of(words); });
}

constexpr const char* compare_examples = R"(
  zproof compare frame.exr model.glb --view cam     one stored frame, against Embree
  zproof compare a.exr b.exr --scene model.glb      one against the other, and both against the scene

The frames' own resolution is taken. Exit status as for run.)";

void add_compare(CLI::App& app, CompareArguments& compare, PartyWords& words) {
    app.add_option("CANDIDATE", words.candidate, "frame to be judged (.exr with id and Z)")->required();
    auto* other =
        app.add_option("SCENE", compare.scene, std::string{scene_words} + "; with --scene: a frame");
    other->required();
    app.add_option_function<std::string>(
        "--scene",
        [&compare, &words, other](const std::string& scene) {
            words.reference = other->as<std::string>();
            compare.scene = scene;
        },
        "the scene, where both words are frames");
    app.add_option("--view", compare.view, "name of the view; needed where the scene has several");
    add_precision_options(app, words);
    add_reference_precision(app, words);
    add_witness_options(app, words);
    add_threads(app, compare.threads);
    add_report(app, compare.report);
    app.callback([&] { compare.parties = parties_of(words); });
    app.footer(compare_examples);
}

void add_explain(CLI::App& app, ExplainArguments& explain, PartyWords& words) {
    app.add_option("SCENE", explain.scene, scene_words)->required();
    app.add_option("X", explain.x, "pixel column, 0 = left")->required()->check(CLI::Range(0, 32767));
    app.add_option("Y", explain.y, "pixel row, 0 = top")->required()->check(CLI::Range(0, 32767));
    app.add_option("--view", explain.view, "name of the view; default: the scene's first");
    add_renderer_options(app, words);
    add_stored_frame_options(app, words);
    add_render_settings(app, explain.settings);
    app.callback([&] { explain.parties = parties_of(words); });
}

constexpr const char* render_examples =
    R"(  zproof render textured_ground -o out            VIEW.exr, id, depth and colour pictures
  zproof render model.glb --filter trilinear-gl   also VIEW-filtered.exr and .png
  zproof render model.glb --filter nearest:uv=affine

Settings of a filter:
)";

void add_render(CLI::App& app, RenderArguments& render, PartyWords& words) {
    app.add_option("SCENE", render.scene, scene_words)->required();
    app.add_option("-o,--out", render.out, "folder for the frames")->capture_default_str();
    add_renderer_options(app, words);
    app.add_option("--filter", words.filter,
                   "also write textures as this method reads them: NAME[:key=value]...");
    add_render_settings(app, render.settings);
    app.footer(std::string{"\n"} + render_examples + filter_settings_help());
    app.callback([&] {
        render.renderer = candidate_of(words);
        if (!words.filter.empty()) render.filter = filter_choice(words.filter);
    });
}

constexpr const char* measure_examples = R"(
  zproof measure zproof                 a table: measured, declared, and whether it is kept
  zproof measure zproof --json          the same for programs
  zproof measure opengl                 an OpenGL driver

Exit status: 0 everything as declared, 1 worse than declared, 2 no such renderer.)";

void add_measure(CLI::App& app, MeasureArguments& measure, PartyWords& words) {
    app.add_option("RENDERER", words.renderer, "a name, or 'CMD {scene} {camera} {width} {height} {out}'")
        ->required();
    add_precision_options(app, words);
    app.add_flag_callback(
        "--json", [&measure] { measure.format = MeasurementFormat::json; }, "print JSON instead of a table");
    app.footer(measure_examples);
    app.callback([&] { measure.renderer = candidate_of(words); });
}

constexpr const char* contract_examples = R"(
  zproof contract-check './mine {scene} {camera} {width} {height} {out}'

Three small scenes; what is wrong is said in words. Exit status: 0 the contract is kept, 1 a frame is
wrong, 3 no frame came.)";

void add_contract_check(CLI::App& app, ContractCheckArguments& check, PartyWords& words) {
    app.add_option("COMMAND", words.renderer, "with {scene}, {camera}, {width}, {height} and {out} in it")
        ->required();
    add_precision_options(app, words);
    add_threads(app, check.threads);
    app.footer(contract_examples);
    app.callback([&] { check.renderer = candidate_of(words); });
}

void add_generate(CLI::App& app, GenerateArguments& generate) {
    app.add_option("NAME", generate.names, "suite scenes (zproof list); none: all");
    app.add_option("-o,--out", generate.out, "folder for the files")->capture_default_str();
}

std::string as_typed(int argc, const char* const* argv) {
    std::string line = "zproof";
    for (int i = 1; i < argc; ++i) line += " " + shell_quoted(argv[i]);
    return line;
}

/// CLI11 throws both for mistakes and for --help; only the former are errors of the user.
Answered answer_or_throw(const CLI::App& app, const CLI::ParseError& e) {
    if (e.get_exit_code() != 0) throw UsageError{std::string{e.what()} + " (see: zproof --help)"};
    std::ostringstream text;
    app.exit(e, text, text);
    return {text.str()};
}

}  // namespace

int available_threads() { return std::clamp(int(std::thread::hardware_concurrency()), 1, 1024); }

Command parse_command_line(int argc, const char* const* argv) {
    CLI::App app{examples, "zproof"};
    app.set_version_flag("--version", version_line);
    app.require_subcommand(0, 1);  // none is answered below, in words that name what is missing

    PartyWords words;
    RunArguments run;
    CompareArguments compare;
    run.report.typed = compare.report.typed = as_typed(argc, argv);
    ExplainArguments explain;
    RenderArguments render;
    MeasureArguments measure;
    ContractCheckArguments contract_check;
    SelftestArguments selftest;
    GenerateArguments generate;
    FiltersWords filters;
    StudyArguments study;
    filters.run.typed = study.typed = run.report.typed;

    CLI::App& run_app = *app.add_subcommand("run", "render, ask the reference, judge, write the reports");
    CLI::App& compare_app = *app.add_subcommand("compare", "judge frames that were rendered elsewhere");
    CLI::App& explain_app = *app.add_subcommand("explain", "tell the whole story of one pixel");
    CLI::App& render_app =
        *app.add_subcommand("render", "write a renderer's frames as EXR and PNG, not judged");
    CLI::App& measure_app = *app.add_subcommand(
        "measure", "what a renderer really does: sub-pixel grid, fill side, depth steps, watertightness");
    CLI::App& contract_app = *app.add_subcommand(
        "contract-check", "does a program keep the renderer contract? three small scenes, answers in words");
    CLI::App& selftest_app =
        *app.add_subcommand("selftest", "see the gate fail: inject known faults into good frames");
    CLI::App& list_app = *app.add_subcommand("list", "the built-in suite: each scene with its reason");
    CLI::App& scenes_app = *app.add_subcommand("scenes", "the built-in suite as files");
    CLI::App& generate_app =
        *scenes_app.add_subcommand("generate", "write suite scenes as .glb and .view.json");
    scenes_app.require_subcommand(0, 1);
    CLI::App& filters_app = *app.add_subcommand(
        "filters", "texture filters held to the exact area integral: run, list, table, figure, check, crow");
    add_run(run_app, run, words);
    add_compare(compare_app, compare, words);
    add_explain(explain_app, explain, words);
    add_render(render_app, render, words);
    add_measure(measure_app, measure, words);
    add_contract_check(contract_app, contract_check, words);
    add_threads(selftest_app, selftest.threads);
    add_generate(generate_app, generate);
    add_filters(filters_app, filters);
    CLI::App& study_app = *app.add_subcommand("study", "the lessons as instruments: what each stage does");
    add_study(study_app, study);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return answer_or_throw(app, e);
    }
    if (run_app.parsed()) return run;
    if (compare_app.parsed()) return compare;
    if (explain_app.parsed()) return explain;
    if (render_app.parsed()) return render;
    if (measure_app.parsed()) return measure;
    if (contract_app.parsed()) return contract_check;
    if (selftest_app.parsed()) return selftest;
    if (list_app.parsed()) return ListArguments{};
    if (generate_app.parsed()) return generate;
    if (filters_app.parsed())
        return std::visit([](auto chosen) { return Command{std::move(chosen)}; },
                          chosen_filters_command(filters_app, filters));
    if (study_app.parsed()) return chosen_study(study_app, study);
    if (scenes_app.parsed()) throw UsageError{"scenes: 'generate' expected (see: zproof scenes --help)"};
    throw UsageError{"a command is expected, such as: zproof run (see: zproof --help)"};
}

std::string shell_quoted(const std::string& word) {
    constexpr const char* harmless =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=:,+@%";
    if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
    std::string quoted = "'";
    for (char c : word) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return quoted + "'";
}

}  // namespace zproof
