/// The shading study as a document.
#pragma once

#include <string>
#include <vector>

#include "lessons/shading/study.h"
#include "reports/pages/document.h"

namespace zproof {

/// Title, introduction and the sphere cut finer and finer.
document::Document shading_document(const study::shading::TessellationStudy& study);

/// One view; `stem` begins the names of its items.
document::Section shading_section(const study::shading::ShadingStudy& study, const std::string& stem);

}  // namespace zproof
