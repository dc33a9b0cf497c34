/// The command line as typed values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cli/gate/arguments.h"
#include "cli/gate/shard.h"
#include "cli/report_files.h"
#include "cli/run_size.h"
#include "oracle/reference_cache.h"
#include "program/command.h"
#include "program/common_arguments.h"
#include "renderers/choice.h"
#include "scenes/import/calibrated_camera.h"

namespace zproof {

/// In whose words the shards' commands are printed.
enum class PlanFormat {
    lines,   ///< a command each
    slurm,   ///< a batch script for an array of jobs
    github,  ///< a matrix of GitHub Actions, JSON
    gitlab,  ///< a job of GitLab CI, YAML
};

/// A run to be planned for.
struct RunWords {
    std::string name;               ///< its profile; empty: that of the settings, or none
    std::vector<std::string> argv;  ///< of the run, with all its settings, without "zproof"
};

struct PlanArguments {
    CommonArguments common{.output = Output::file, .out = "plan.json"};
    int shards = 0;
    std::vector<std::filesystem::path> earlier;  ///< results of earlier runs
    PlanFormat format = PlanFormat::lines;
    std::vector<RunWords> runs;  ///< one per renderer
};

/// Whose file of cameras it is.
struct InitArguments {
    CommonArguments common{.output = Output::folder, .out = "."};
    enum class Language { python, cpp, opengl } language = Language::python;
};

enum class CameraSource { opencv, colmap, nerf };

struct ViewsArguments {
    CommonArguments common{
        .output = Output::file};  ///< the view file; no default, so that none is replaced unasked
    CameraSource source = CameraSource::opencv;
    std::filesystem::path cameras;  ///< COLMAP: a folder
    std::filesystem::path model;
    DepthRange range{.near_depth = 0, .far_depth = std::numeric_limits<double>::infinity()};
    std::optional<glm::ivec2> image_size;  ///< of files that do not say it
};

enum class MeasurementFormat {
    table,  ///< for people
    json,   ///< for programs: docs/measure.md
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

/// The reports of a run: a folder of them.
struct ReportArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-out"};
    PictureMode pictures = PictureMode::none;
    Evidence evidence = Evidence::defects;
    CauseSearch diagnosis = CauseSearch::done;
    std::vector<ReportFormat> formats = usual_formats();
    enum class Columns { that_fit, all } columns = Columns::that_fit;  ///< of the table of views
    GateArguments gate{};
    std::string typed{};              ///< the command line, quoted for a shell
    std::vector<std::string> argv{};  ///< the same, word by word
};

/// Scenes drawn by chance (scenes/random_scenes.h).
struct RandomChoice {
    std::uint64_t count = 0, seed = 1;
    std::string kind = "any";

    std::vector<std::string> words() const;  ///< numbers from 0 on
};

/// Does a run go on where the first views were all refused in the same words?
enum class Persistence { ends, keeps_going };

/// What ends a run before all is judged.
struct EarlyEndRule {
    int max_failed_views = 0;  ///< 0: however many fail
    Persistence persistence = Persistence::ends;
};

struct RunArguments {
    RunSize size = RunSize::usual;
    std::vector<std::string> scenes;    ///< empty: the whole suite, or those of `only_failed`
    std::filesystem::path only_failed;  ///< results of a run: only views that failed there; empty: all
    std::filesystem::path models;       ///< where view files' models may lie; empty: beside them only
    std::filesystem::path plan;         ///< that says all of this but the shard; empty: there is none
    Shard shard;
    ShardStatus shard_status = ShardStatus::is_the_verdict;
    oracle::ReferenceCacheChoice reference_cache;
    EarlyEndRule early_end;
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
    CommonArguments common;
    std::string scene;
    std::filesystem::path models;  ///< where view files' models may lie; empty: beside them only
    int x = 0, y = 0;              ///< pixel
    std::string view;              ///< empty: the scene's first view
    ChosenRenderers renderers;     ///< oracles are not asked
    RenderSettings settings;
};

struct RenderArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-render"};
    std::string scene;
    std::filesystem::path models;  ///< where view files' models may lie; empty: beside them only
    RendererChoice renderer;
    std::string filter;       ///< also write the textures, read this way; empty: not
    bool attributes = false;  ///< also write what our rasterizer interpolates over the triangles
    RenderSettings settings;
};

struct MeasureArguments {
    CommonArguments common;
    RendererChoice renderer;
    MeasurementFormat format = MeasurementFormat::table;
    std::filesystem::path emit;  ///< for the measured precision; empty: it is not written
};

struct FitArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-fit"};
    std::vector<std::string> scenes;  ///< empty: the whole suite
    std::string view;                 ///< empty: all; of a stored frame, the scene's only one
    RendererChoice renderer;
    RenderSettings settings;
    std::string typed;  ///< the command line, quoted for a shell
};

struct SelfcheckArguments {
    CommonArguments common;
    std::vector<std::string> scenes;  ///< empty: the whole suite
    RendererChoice renderer;
    RenderSettings settings{.resolution = {480, 270}};
};

/// Everything that is asked of a device, on one page.
struct ConformanceArguments {
    RendererChoice renderer;
    RandomChoice random{.count = 300};
    ReportArguments report{.common = {.output = Output::folder, .out = "zproof-conformance"}};
};

struct ContractCheckArguments {
    CommonArguments common;
    RendererChoice renderer;
};

struct SelftestArguments {
    CommonArguments common;
};

/// What becomes of a plan's shards that are not there.
enum class Missing {
    is_refused,
    is_not_judged,  ///< each of their views says so, and nothing is proven
};

/// Shards of one run, put together.
struct MergeArguments {
    std::vector<std::filesystem::path> shards;  ///< output folders
    std::filesystem::path plan;                 ///< of which they are; empty: shards by hash
    Missing missing = Missing::is_refused;      ///< of a plan's shards
    ReportArguments report;
};

struct ListArguments {
    CommonArguments common;
    enum class Detail { reasons, names } detail = Detail::reasons;
};

struct GenerateArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-scenes"};
    std::vector<std::string> names;  ///< empty: the whole suite
};

struct RandomScenesArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-scenes"};
    RandomChoice random{.count = 12};
};

/// The run that a plan's words mean; they hold all its settings. Throws as parse_command_line() does.
RunArguments planned_run(const std::vector<std::string>& argv);

/// What is not typed is taken from the settings (docs/gate.md). Throws UsageError, and ReportError where a
/// settings file that is named cannot be read.
Command parse_command_line(int argc, const char* const* argv, const Environment& environment);

}  // namespace zproof
