/// The command line as typed values.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/filter_choice.h"
#include "cli/filters/arguments.h"
#include "cli/renderers/choice.h"
#include "cli/settings.h"
#include "cli/study/arguments.h"

namespace zproof {

enum class ColourWish {
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

enum class PictureWish {
    none,
    shaded,  ///< colour pictures of every view, also from witnesses that can paint
};

/// Where the reports go and what the terminal shows.
struct ReportArguments {
    std::filesystem::path out = "zproof-out";
    ColourWish colour = ColourWish::automatic;
    ProgressStyle progress = ProgressStyle::automatic;
    Detail detail = Detail::table;
    PictureWish pictures = PictureWish::none;
    std::string typed;  ///< the command line, quoted for a shell
};

struct RunArguments {
    std::vector<std::string> scenes;  ///< empty: the whole suite
    Parties parties;
    RenderSettings settings;
    ReportArguments report;
};

struct CompareArguments {
    std::string scene;
    std::string view;  ///< empty: the scene's only view
    Parties parties;   ///< the candidate is a stored frame
    int threads = available_threads();
    ReportArguments report;
};

struct ExplainArguments {
    std::string scene;
    int x = 0, y = 0;  ///< pixel
    std::string view;  ///< empty: the scene's first view
    Parties parties;   ///< witnesses are not asked
    RenderSettings settings;
};

struct RenderArguments {
    std::string scene;
    RendererChoice renderer;
    std::optional<FilterChoice> filter;  ///< also write the textures, read this way
    std::filesystem::path out = "zproof-render";
    RenderSettings settings;
};

struct MeasureArguments {
    RendererChoice renderer;
    MeasurementFormat format = MeasurementFormat::table;
};

struct ContractCheckArguments {
    RendererChoice renderer;
    int threads = available_threads();
};

struct SelftestArguments {
    int threads = available_threads();
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
                 ContractCheckArguments, SelftestArguments, ListArguments, GenerateArguments,
                 FiltersRunArguments, FiltersListArguments, FiltersTableArguments, FiltersFigureArguments,
                 FiltersCrowArguments, FiltersCheckArguments, StudyArguments, Answered>;

/// Throws UsageError.
Command parse_command_line(int argc, const char* const* argv);

/// The word as a POSIX shell must be given it.
std::string shell_quoted(const std::string& word);

}  // namespace zproof
