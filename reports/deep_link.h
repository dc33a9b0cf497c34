/// Addresses of single pixels in report.html.
#pragma once

#include <string>

#include "reports/results.h"

namespace zproof {

/// "report.html#view=room-corner&x=812&y=344", relative to the run's folder: the page opens its viewer at
/// that pixel, from disk as well. Empty where the view left no folder, since then there is nothing to see.
std::string deep_link(const ViewResult& view, int x, int y);

/// The name by which links mean a view: the last part of its folder, unique within a run.
std::string link_name(const ViewResult& view);

}  // namespace zproof
