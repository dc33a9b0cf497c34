#include "reports/deep_link.h"

#include "reports/wording.h"

namespace zproof {

std::string link_name(const ViewResult& view) { return view.folder.substr(view.folder.rfind('/') + 1); }

std::string deep_link(const ViewResult& view, int x, int y) {
    if (view.folder.empty()) return "";
    return "report.html#view=" + as_url(link_name(view)) + "&x=" + std::to_string(x) +
           "&y=" + std::to_string(y);
}

}  // namespace zproof
