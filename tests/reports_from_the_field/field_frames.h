/// Wrong frames that people reported of renderers, rebuilt from the reports' numbers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::field_reports {

/// What is put before the judge.
struct Shown {
    Scene scene;
    View view;
    Frame frame;
};

struct FieldFrame {
    std::string name;                 ///< letters, digits and '_'
    std::vector<std::string> causes;  ///< the right one, in the words of the diagnosis; any of them
    std::string source;               ///< where it was reported
    std::function<Shown()> rebuild;
    Precision declared = RasterPrecision{.transform = Arithmetic::float64};
};

/// The yard as another camera sees it.
std::function<Shown()> seen_by(const View& view, const std::function<void(Camera&)>& change);

std::vector<FieldFrame> frames_of_drawing();
std::vector<FieldFrame> frames_of_place();
std::vector<FieldFrame> frames_of_conventions();  ///< those of place hold them
std::vector<FieldFrame> frames_of_depth();
std::vector<FieldFrame> frames_of_depth_pictures();
std::vector<FieldFrame> frames_of_resolves();
std::vector<FieldFrame> frames_of_ids();

}  // namespace zproof::field_reports
