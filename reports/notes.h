/// What the notes of scenes say, in a terminal.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "reports/results.h"

namespace zproof {

/// The notes of scenes by kind, which is what stands before a note's first ": ".
class NoteKinds {
  public:
    void add(const std::string& scene, const std::vector<std::string>& notes);

    /// A line for each kind, in order of appearance: "note: room: images not read: 3", or where they differ
    /// among scenes, "note: 4 scenes: images not read".
    std::string lines() const;

  private:
    struct Kind {
        std::string name;
        std::set<std::string> notes, scenes;
    };
    std::vector<Kind> kinds_;
};

std::string note_lines(const std::string& scene, const std::vector<std::string>& notes);

/// The notes of all views.
std::string note_lines(const Results& results);

}  // namespace zproof
