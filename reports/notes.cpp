#include "reports/notes.h"

#include <algorithm>
#include <set>
#include <vector>

#include "reports/wording.h"

namespace zproof {

namespace {

struct Kind {
    std::string name;
    std::set<std::string> notes, scenes;
};

std::vector<Kind> kinds_in(const Results& results) {
    std::vector<Kind> kinds;
    for (const ViewResult& view : results.views)
        for (const std::string& note : view.notes) {
            const std::string name = note.substr(0, note.find(": "));
            auto kind = std::ranges::find(kinds, name, &Kind::name);
            if (kind == kinds.end()) kind = kinds.insert(kind, Kind{name, {}, {}});
            kind->notes.insert(note);
            kind->scenes.insert(view.scene);
        }
    return kinds;
}

}  // namespace

std::string note_lines(const Results& results) {
    constexpr std::size_t most_told = 4;  // of one kind and one scene
    std::string lines;
    for (const auto& [name, notes, scenes] : kinds_in(results)) {
        const std::string where = scenes.size() == 1 ? *scenes.begin() : counted(scenes.size(), "scene");
        const bool told = notes.size() == 1 || (scenes.size() == 1 && notes.size() <= most_told);
        for (const std::string& text : told ? notes : std::set{name})
            lines += shortened("note: " + where + ": " + text, longest_line_bytes) + "\n";
    }
    return lines;
}

}  // namespace zproof
