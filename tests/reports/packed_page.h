/// What a page holds in base64, read back.
#pragma once

#include <string>

#include "reports/planes/container.h"

namespace zproof {

/// The text that the element of that id packs; empty where the page has none.
std::string packed_text(const std::string& page, const std::string& id);

/// The planes of the view of that anchor. Throws ReportError where the page has none.
planes::Container embedded_planes(const std::string& page, const std::string& anchor);

}  // namespace zproof
