/// The cost study as a document.
#pragma once

#include <string>
#include <vector>

#include "lessons/cost/study.h"
#include "reports/pages/document.h"

namespace zproof {

/// Title, introduction and the sections of the model.
document::Document cost_document(const study::cost::Model& model);

/// The model held against scenes that took no part in it. Nothing where there is none.
std::vector<document::Section> prediction_sections(const std::vector<study::cost::Prediction>& predictions);

/// The optimizations on one view; `stem` begins the names of its items.
document::Section optimization_section(const study::cost::OptimizationStudy& study, const std::string& stem);

}  // namespace zproof
