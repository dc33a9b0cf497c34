#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <sstream>
#include <thread>

#include "cli/usage_error.h"
#include "cli/version.h"

namespace zproof {
namespace {

constexpr const char* examples = R"(Proves a z-buffer rasterizer right, pixel by pixel.

  zproof run                            judge the built-in suite, write zproof-out/
  zproof run models/ -o out             judge every .gltf, .glb and .view.json below models/
  zproof explain model.glb 812 344      tell the whole story of one pixel
  zproof measure zproof                 measure what a renderer really does

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

void add_render_settings(CLI::App& app, RenderSettings& settings) {
    app.add_option("--width", settings.resolution.width, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    app.add_option("--height", settings.resolution.height, "pixels; view files state their own")
        ->check(CLI::Range(1, 32768))
        ->capture_default_str();
    app.add_option("--threads", settings.threads, "the verdict is the same for any number")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
}

void add_run(CLI::App& app, RunArguments& run) {
    app.add_option("SCENE", run.scenes,
                   std::string{"'suite', a folder, or a "} + scene_words + "; none: the whole suite");
    app.add_option("-o,--out", run.out, "folder for the reports")->capture_default_str();
    add_render_settings(app, run.settings);
    add_choice(app, "--color", run.colour, colour_wishes);
    add_choice(app, "--progress", run.progress, progress_styles);
    auto* quiet = app.add_flag_callback(
        "-q,--quiet",
        [&run] {
            run.detail = Detail::verdict;
            run.progress = ProgressStyle::none;
        },
        "print the verdict only");
    app.add_flag_callback(
           "--times", [&run] { run.detail = Detail::times; }, "also print where the time went")
        ->excludes(quiet);
}

void add_explain(CLI::App& app, ExplainArguments& explain) {
    app.add_option("SCENE", explain.scene, scene_words)->required();
    app.add_option("X", explain.x, "pixel column, 0 = left")->required()->check(CLI::Range(0, 32767));
    app.add_option("Y", explain.y, "pixel row, 0 = top")->required()->check(CLI::Range(0, 32767));
    app.add_option("--view", explain.view, "name of the view; default: the scene's first");
    add_render_settings(app, explain.settings);
}

void add_render(CLI::App& app, RenderArguments& render) {
    app.add_option("SCENE", render.scene, scene_words)->required();
    app.add_option("-o,--out", render.out, "folder for the frames")->capture_default_str();
    add_render_settings(app, render.settings);
}

constexpr const char* measure_examples = R"(
  zproof measure zproof                 a table: measured, declared, and whether it is kept
  zproof measure zproof --json          the same for programs

Exit status: 0 everything as declared, 1 worse than declared, 2 no such renderer.)";

void add_measure(CLI::App& app, MeasureArguments& measure) {
    app.add_option("RENDERER", measure.renderer, "'zproof', its own rasterizer")->required();
    app.add_flag_callback(
        "--json", [&measure] { measure.format = MeasurementFormat::json; }, "print JSON instead of a table");
    app.footer(measure_examples);
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

    RunArguments run;
    run.typed = as_typed(argc, argv);
    ExplainArguments explain;
    RenderArguments render;
    MeasureArguments measure;
    GenerateArguments generate;

    CLI::App& run_app = *app.add_subcommand("run", "render, ask the reference, judge, write the reports");
    CLI::App& explain_app = *app.add_subcommand("explain", "tell the whole story of one pixel");
    CLI::App& render_app = *app.add_subcommand("render", "write the rasterizer's frames as EXR and PNG");
    CLI::App& measure_app = *app.add_subcommand(
        "measure", "what a renderer really does: sub-pixel grid, fill side, depth steps, watertightness");
    CLI::App& list_app = *app.add_subcommand("list", "the built-in suite: each scene with its reason");
    CLI::App& scenes_app = *app.add_subcommand("scenes", "the built-in suite as files");
    CLI::App& generate_app =
        *scenes_app.add_subcommand("generate", "write suite scenes as .glb and .view.json");
    scenes_app.require_subcommand(0, 1);
    add_run(run_app, run);
    add_explain(explain_app, explain);
    add_render(render_app, render);
    add_measure(measure_app, measure);
    add_generate(generate_app, generate);

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return answer_or_throw(app, e);
    }
    if (run_app.parsed()) return run;
    if (explain_app.parsed()) return explain;
    if (render_app.parsed()) return render;
    if (measure_app.parsed()) return measure;
    if (list_app.parsed()) return ListArguments{};
    if (generate_app.parsed()) return generate;
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
