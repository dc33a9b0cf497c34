/// zproof filters as typed values.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/filter_choice.h"
#include "cli/settings.h"
#include "frame/filter_precision.h"
#include "oracle/area_integral.h"
#include "reports/filters/crops.h"

namespace CLI {
class App;
}

namespace zproof {

struct FiltersRunArguments {
    std::vector<std::string> scenes;    ///< empty: every built-in filter scene
    std::vector<FilterChoice> methods;  ///< at least one, no two typed alike
    oracle::Reconstruction truth = oracle::Reconstruction::nearest;
    std::vector<std::string> views;    ///< empty: all of every scene
    std::optional<int> width, height;  ///< pixels; none: the scene's own
    std::optional<int> first_row;      ///< study::Plan::first_row; none: the scene's own
    int threads = available_threads();
    int flicker_steps = 2;  ///< 0: not measured
    std::filesystem::path out = "zproof-filters";
    ProgressStyle progress = ProgressStyle::automatic;
    std::string typed;  ///< the command line, quoted for a shell
};

struct FiltersListArguments {};

struct FiltersScenesArguments {
    std::vector<std::string> names;  ///< empty: all
    std::filesystem::path out = "zproof-filter-scenes";
};

enum class TableFormat { terminal, latex, csv };

struct FiltersTableArguments {
    std::filesystem::path folder;
    std::string region = "interior";
    TableFormat format = TableFormat::terminal;
};

struct FiltersFigureArguments {
    std::filesystem::path folder;
    std::vector<std::string> labels;
    std::optional<CropBox> crop;
};

struct FiltersCrowArguments {
    RenderSettings settings{.resolution = {512, 512}};
    std::filesystem::path out = "zproof-crow";
};

struct FiltersCheckArguments {
    std::vector<FilterChoice> methods;  ///< at least one; with a picture exactly one
    std::vector<std::string> scenes;    ///< empty: every built-in filter scene
    std::vector<std::string> views;     ///< empty: all of every scene
    std::optional<int> width, height;   ///< pixels; none: the scene's own
    int threads = available_threads();
    std::filesystem::path picture;             ///< somebody's own, in place of ours; empty: none
    std::optional<FilterPrecision> precision;  ///< none: what zproof's own filters promise
};

/// What is bound while a command line is read.
struct FiltersWords {
    std::string methods = "all", truth = "N", views, crop, only;
    FiltersRunArguments run;
    FiltersListArguments list;
    FiltersScenesArguments scenes;
    FiltersTableArguments table;
    FiltersFigureArguments figure;
    FiltersCrowArguments crow;
    FiltersCheckArguments check;
    std::string check_methods, check_views, precision;
};

/// "all" and methods with settings, separated by commas, each as `choice` understands it. Throws UsageError.
std::vector<FilterChoice> filter_choices(const std::string& words,
                                         FilterChoice (*choice)(const std::string&));

}  // namespace zproof
