/// zproof filters as typed values.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/bounds/pixel_coord.h"
#include "filters/area/area_integral.h"
#include "filters/commands/filter_choice.h"
#include "filters/commands/pictures.h"
#include "filters/conformance/filter_precision.h"
#include "filters/normals/normal_study.h"
#include "filters/report/crops.h"
#include "filters/report/table_cells.h"
#include "program/common_arguments.h"
#include "program/settings.h"

namespace CLI {
class App;
}

namespace zproof {

struct FiltersRunArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-filters"};
    std::vector<std::string> scenes;      ///< empty: every built-in filter scene
    std::vector<FilterChoice> methods;    ///< at least one, no two typed alike
    std::vector<PictureChoice> pictures;  ///< of anybody's renderer, beside the methods
    oracle::Reconstruction truth = oracle::Reconstruction::nearest;
    std::vector<std::string> views;    ///< empty: all of every scene
    std::optional<int> width, height;  ///< pixels; none: the scene's own
    std::optional<int> first_row;      ///< study::Plan::first_row; none: the scene's own
    int flicker_steps = 2;             ///< 0: not measured
    bool writes_evidence = false;      ///< filters/commands/evidence_files.h
    std::optional<CropBox> inspected;  ///< whose every pixel is told in the viewer; none: the worst alone
    std::string typed;                 ///< the command line, quoted for a shell
};

struct FiltersListArguments {
    CommonArguments common;
};

struct FiltersScenesArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-filter-scenes"};
    std::vector<std::string> names;  ///< empty: all
};

struct FiltersReproduceArguments {
    CommonArguments common;
    std::vector<std::string> names;  ///< of study::published_results(); empty: all
};

enum class TableFormat { terminal, latex, csv };

struct FiltersTableArguments {
    CommonArguments common;
    std::filesystem::path folder;
    TableChoice choice;
    TableFormat format = TableFormat::terminal;
    bool is_pooled = false;  ///< all textures together; choice.columns are metrics then
    std::string baseline;    ///< of the pool; empty: the best method
};

struct FiltersFigureArguments {
    CommonArguments common{.output = Output::folder};  ///< empty: the study's own
    std::filesystem::path folder;
    std::vector<std::string> labels;
    std::optional<CropBox> crop;
};

struct FiltersCrowArguments {
    CommonArguments common{.output = Output::folder, .out = "zproof-crow"};
    RenderSettings settings{.resolution = {512, 512}};
};

struct FiltersNormalsArguments {
    CommonArguments common;
    std::filesystem::path map;          ///< an image; empty: bumps of our own
    std::vector<FilterChoice> methods;  ///< at least one
    std::vector<std::string> views;     ///< empty: all
    Resolution resolution{256, 256};
    normals::Light light;
};

enum class CheckFormat { lines, json };

struct FiltersCheckArguments {
    CommonArguments common;
    std::vector<FilterChoice> methods;  ///< at least one; with a picture exactly one
    std::vector<std::string> scenes;    ///< empty: every built-in filter scene
    std::vector<std::string> views;     ///< empty: all of every scene
    std::optional<int> width, height;   ///< pixels; none: the scene's own
    std::filesystem::path picture;      ///< somebody's own, in place of ours; empty: none
    CheckFormat format = CheckFormat::lines;
    std::optional<FilterPrecision> precision;  ///< none: what zproof's own filters promise
};

struct FiltersExplainArguments {
    CommonArguments common;
    std::string scene, view;
    PixelCoord pixel;
    std::vector<FilterChoice> methods;  ///< at least one
    oracle::Reconstruction truth = oracle::Reconstruction::nearest;
    std::optional<int> width, height;  ///< pixels; none: the scene's own
    std::filesystem::path picture;     ///< somebody's own, that claims to be of the one method; empty: none
    PictureClaim claim;                ///< of that picture
};

/// Frames that zproof render wrote, to be shown as a filter reads their textures.
struct FiltersFilteredArguments {
    CommonArguments common;
    std::string scene;
    std::filesystem::path models, frames;  ///< of frames, the folder; empty: nothing is made
    std::optional<FilterChoice> filter;
    Resolution resolution = default_resolution;
    std::vector<Sample> samples{Sample{}};
};

struct FiltersSelftestArguments {
    CommonArguments common;
};

/// What is bound while a command line is read.
struct FiltersWords {
    std::string methods = "all", truth = "N", views, crop, only, inspected;
    std::vector<std::string> pictures;
    std::string table_columns;
    FiltersRunArguments run;
    FiltersListArguments list;
    FiltersScenesArguments scenes;
    FiltersReproduceArguments reproduce;
    FiltersTableArguments table;
    FiltersFigureArguments figure;
    FiltersCrowArguments crow;
    FiltersNormalsArguments normals;
    std::string normal_methods = "trilinear-gl,aniso-midpoint", normal_views;
    double half_angle = 20;  ///< degrees
    FiltersCheckArguments check;
    ClaimWords claims;
    std::string check_methods, check_views, precision;
    FiltersFilteredArguments filtered;
    std::string filter, sample;
    FiltersSelftestArguments selftest;
    FiltersExplainArguments explain;
    std::string explained_methods, explained_pixel, explained_truth = "N", explained_promise;
};

/// "all" and methods with settings, separated by commas, each as `choice` understands it. Throws UsageError.
std::vector<FilterChoice> filter_choices(const std::string& words,
                                         FilterChoice (*choice)(const std::string&));

}  // namespace zproof
