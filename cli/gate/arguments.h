/// The commands around the gate as typed values: report, diff-results, waive, doctor.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/gate/gate.h"
#include "cli/report_files.h"
#include "program/common_arguments.h"
#include "program/settings/sources.h"

namespace zproof {

/// Results shown again.
struct ReportAgainArguments {
    CommonArguments common{.output = Output::file, .out = "report.html"};  ///< "-": stdout
    std::vector<std::filesystem::path> results;  ///< results.json, or the folders that hold one
    std::optional<ReportFormat> format;          ///< nothing: by the ending of `out`
};

enum class DifferenceFormat { table, json };

struct DiffResultsArguments {
    CommonArguments common;
    std::filesystem::path before, after;  ///< results.json, or the folders that hold one
    DifferenceFormat format = DifferenceFormat::table;
};

struct WaiveListArguments {
    CommonArguments common;
    GateArguments gate;
};

struct WaiveCheckArguments {
    CommonArguments common;
    GateArguments gate;
    std::filesystem::path results;  ///< of a run, to find waivers without use; empty: none
};

struct WaivePruneArguments {
    CommonArguments common{.output = Output::file};  ///< empty: the file of waivers itself
    GateArguments gate;
    std::filesystem::path results;  ///< as above: those without use go as well
};

/// What of the pixel's surroundings a new waiver is to cover.
enum class WaiverReach {
    pair,      ///< every pixel of the view with the same two answers
    triangle,  ///< every pixel at which the candidate's triangle is named
    pixels,    ///< the pixels that were named
};

struct WaiveAddArguments {
    CommonArguments common{.output = Output::file};  ///< empty: the file of waivers itself
    GateArguments gate;
    std::filesystem::path results;
    std::string scene, view;          ///< view empty: the scene's only one
    std::vector<std::string> pixels;  ///< "X,Y"; one at least
    WaiverReach reach = WaiverReach::pair;
    std::string id, reason, link, expires;
};

/// What zproof stands on, and which settings hold here.
struct DoctorArguments {
    CommonArguments common;
    SettingsChoice settings;
};

}  // namespace zproof
