/// The command line as typed values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/filter_choice.h"
#include "cli/filters/arguments.h"
#include "cli/gate/arguments.h"
#include "cli/renderers/choice.h"
#include "cli/report_files.h"
#include "cli/run_size.h"
#include "cli/settings.h"
#include "cli/study/arguments.h"
#include "cli/views_arguments.h"

namespace zproof {

enum class ColourMode {
    automatic,  ///< on a terminal, unless NO_COLOR is set or TERM is "dumb"
    always,
    never,
};

enum class MeasurementFormat {
    table,  ///< for people
    json,   ///< for programs: docs/measure.md
};

enum class Detail {
    verdict,  ///< the last line only
    table,    ///< a row per view and the verdict
    times,    ///< the same, and where the time went
};

enum class PictureMode {
    none,
    shaded,  ///< colour pictures of every view that leaves evidence, also from oracles that can paint
};

/// Which views leave evidence beside the results: frames, pictures, findings, what the viewer shows.
enum class Evidence {
    all,
    defects,  ///< those with a pixel that fails the gate, waived or not
};

/// Where the reports go and what the terminal shows.
struct ReportArguments {
    std::filesystem::path out = "zproof-out";
    ColourMode colour = ColourMode::automatic;
    ProgressStyle progress = ProgressStyle::automatic;
    Detail detail = Detail::table;
    PictureMode pictures = PictureMode::none;
    Evidence evidence = Evidence::defects;
    std::vector<ReportFormat> formats = usual_formats();
    GateArguments gate{};
    std::string typed{};              ///< the command line, quoted for a shell
    std::vector<std::string> argv{};  ///< the same, word by word
};

struct RunArguments {
    RunSize size = RunSize::usual;
    std::vector<std::string> scenes;  ///< empty: the whole suite
    std::filesystem::path models;     ///< where view files' models may lie; empty: beside them only
    Shard shard;
    ChosenRenderers renderers;
    RenderSettings settings;
    ReportArguments report;
};

struct CompareArguments {
    std::string scene;
    std::filesystem::path models;  ///< where view files' models may lie; empty: beside them only
    std::string view;              ///< empty: the scene's only view
    ChosenRenderers renderers;     ///< the candidate is a stored frame
    RenderSettings settings;       ///< the resolution is the frame's
    ReportArguments report{.evidence = Evidence::all};  ///< one frame, which somebody asks about
};

struct ExplainArguments {
    std::string scene;
    std::filesystem::path models;  ///< where view files' models may lie; empty: beside them only
    int x = 0, y = 0;              ///< pixel
    std::string view;              ///< empty: the scene's first view
    ChosenRenderers renderers;     ///< oracles are not asked
    RenderSettings settings;
};

struct RenderArguments {
    std::string scene;
    std::filesystem::path models;  ///< where view files' models may lie; empty: beside them only
    RendererChoice renderer;
    std::optional<FilterChoice> filter;  ///< also write the textures, read this way
    bool attributes = false;             ///< also write what our rasterizer interpolates over the triangles
    std::filesystem::path out = "zproof-render";
    RenderSettings settings;
};

struct MeasureArguments {
    RendererChoice renderer;
    MeasurementFormat format = MeasurementFormat::table;
    std::filesystem::path emit;  ///< for the measured precision; empty: it is not written
};

struct FitArguments {
    std::vector<std::string> scenes;  ///< empty: the whole suite
    std::string view;                 ///< empty: all; of a stored frame, the scene's only one
    RendererChoice renderer;
    RenderSettings settings;
    std::filesystem::path out = "zproof-fit";
    std::string typed;  ///< the command line, quoted for a shell
};

struct ContractCheckArguments {
    RendererChoice renderer;
    int threads = available_threads();
};

struct SelftestArguments {
    int threads = available_threads();
};

/// Shards of one run, put together.
struct MergeArguments {
    std::vector<std::filesystem::path> shards;  ///< output folders
    ReportArguments report;
};

struct ListArguments {};

struct GenerateArguments {
    std::vector<std::string> names;  ///< empty: the whole suite
    std::filesystem::path out = "zproof-scenes";
};

/// Text that the command line asked for: --help or --version.
struct Answered {
    std::string text;
};

using Command =
    std::variant<RunArguments, CompareArguments, ExplainArguments, RenderArguments, MeasureArguments,
                 FitArguments, ContractCheckArguments, SelftestArguments, MergeArguments,
                 ReportAgainArguments, DiffResultsArguments, WaiveListArguments, WaiveCheckArguments,
                 WaivePruneArguments, WaiveAddArguments, DoctorArguments, ListArguments, GenerateArguments,
                 ViewsArguments, FiltersRunArguments, FiltersListArguments, FiltersScenesArguments,
                 FiltersTableArguments, FiltersFigureArguments, FiltersCrowArguments, FiltersCheckArguments,
                 StudyArguments, Answered>;

/// What is not typed is taken from the settings (docs/gate.md). Throws UsageError, and ReportError where a
/// settings file that is named cannot be read.
Command parse_command_line(int argc, const char* const* argv, const Environment& environment);

/// The word as a POSIX shell must be given it.
std::string shell_quoted(const std::string& word);

/// "zproof" and the words, each quoted as it must be.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace zproof
