#include "filters/report/provenance.h"

#include <set>

#include "reports/wording.h"

namespace zproof {

using namespace study;

using Facts = std::vector<std::pair<std::string, std::string>>;

Facts provenance_of(const StudyResults& results) {
    return {{"zproof:version", results.version},     {"zproof:commit", results.commit},
            {"zproof:command", results.command},     {"zproof:compiler", results.compiler},
            {"zproof:processor", results.processor}, {"zproof:date", results.date},
            {"zproof:truth", "GT-" + results.truth}};
}

Facts provenance_of(const StudyResults& results, const ViewStudy& view) {
    Facts facts = provenance_of(results);
    facts.insert(facts.end(), {{"zproof:scene", view.scene},
                               {"zproof:view", view.view},
                               {"zproof:scene_sha256", view.scene_sha256}});
    return facts;
}

std::string provenance_comment(const StudyResults& results) {
    std::string text;
    for (const auto& [name, value] : provenance_of(results))
        text += "# " + name + " " + one_line(value) + "\n";
    std::set<std::pair<std::string, std::string>> scenes;
    for (const ViewStudy& view : results.views) scenes.emplace(view.scene, view.scene_sha256);
    for (const auto& [scene, sha256] : scenes)
        text += "# zproof:scene_sha256 " + sha256 + " " + one_line(scene) + "\n";
    return text;
}

}  // namespace zproof
