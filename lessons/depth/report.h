/// The depth study as a document.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lessons/depth/study.h"
#include "reports/pages/document.h"

namespace zproof {

/// Planes that somebody asks a format for.
struct DepthQuestion {
    study::depth::Planes planes;
    double gap = 0;  ///< scene units; 0: none was named
};

document::Document depth_document(const study::depth::GapStudy& gaps, const DepthQuestion& question);

/// The sections of one view; `stem` begins the names of its items.
std::vector<document::Section> depth_sections(const study::depth::DepthStudy& study, const std::string& stem);

}  // namespace zproof
