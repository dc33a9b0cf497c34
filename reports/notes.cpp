#include "reports/notes.h"

#include <algorithm>

#include "reports/wording.h"

namespace zproof {

void NoteKinds::add(const std::string& scene, const std::vector<std::string>& notes) {
    for (const std::string& note : notes) {
        const std::string name = note.substr(0, note.find(": "));
        auto kind = std::ranges::find(kinds_, name, &Kind::name);
        if (kind == kinds_.end()) kind = kinds_.insert(kind, Kind{name, {}, {}});
        kind->notes.insert(note);
        kind->scenes.insert(scene);
    }
}

std::string NoteKinds::lines() const {
    constexpr std::size_t most_told = 4;  // of one kind and one scene
    std::string lines;
    for (const auto& [name, notes, scenes] : kinds_) {
        const std::string where = scenes.size() == 1 ? *scenes.begin() : counted(scenes.size(), "scene");
        const bool told = notes.size() == 1 || (scenes.size() == 1 && notes.size() <= most_told);
        for (const std::string& text : told ? notes : std::set{name})
            lines += shortened("note: " + where + ": " + text, longest_line_bytes) + "\n";
    }
    return lines;
}

std::string note_lines(const std::string& scene, const std::vector<std::string>& notes) {
    NoteKinds kinds;
    kinds.add(scene, notes);
    return kinds.lines();
}

std::string note_lines(const Results& results) {
    NoteKinds kinds;
    for (const ViewResult& view : results.views) kinds.add(view.scene, view.notes);
    return kinds.lines();
}

}  // namespace zproof
