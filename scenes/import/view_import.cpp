#include "scenes/import/view_import.h"

#include <set>

#include "scenes/refusal.h"

namespace zproof {

void require_unique_names(const std::filesystem::path& file, const std::vector<ImportedView>& views) {
    if (views.empty()) refuse(file, "views", "none; expected at least one image with a pose");
    std::set<std::string> names;
    for (const ImportedView& imported : views)
        if (!names.insert(imported.view.name).second)
            refuse(file, "views", "two are called '" + imported.view.name + "'; expected a name for each");
}

}  // namespace zproof
