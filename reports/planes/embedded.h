/// The planes of views as elements of a page, as many of them as its budget allows.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reports/page_text.h"
#include "reports/planes/container.h"

namespace zproof::planes {

/// A view whose planes a page may hold.
struct PlanesFile {
    std::string anchor;          ///< the element's id is "planes-" and this
    std::filesystem::path file;  ///< planes.zvp; need not be there
    bool goes_first = false;     ///< are all its blocks taken before those of the others? Tier 0 of all comes
                                 ///< before the second one that does.
};

/// The rounds in which blocks ask for room.
struct Tiers {
    int count = 1;
    int (*of)(const std::string& block) = nullptr;  ///< from 0
    /// Which blocks lie in one script beside the page where it has no room for them; null: they are left out.
    std::string (*script_of)(const std::string& block) = nullptr;
};

/// A script that lies beside a page.
struct ScriptFile {
    std::string name;  ///< "planes/view-1-2.js", from the page
    Page text;
};

/// What a page takes of some views. Its base64 is made when the page is written.
class EmbeddedPlanes {
  public:
    /// `budget`: bytes of the page. Throws ReportError where a file is damaged.
    EmbeddedPlanes(std::vector<PlanesFile> files, const Tiers& tiers, std::size_t budget);

    bool has_planes(std::size_t view) const { return !choices_[view].taken.empty(); }
    /// The containers of what it takes; the headers of those that lack blocks name them in "leftOut", and in
    /// "scripts" by the file beside the page.
    void append_to(Page& page) const;
    /// Calls zproofPlanes(NAME, CONTAINER AS BASE64) of the blocks that the page does not hold: a page from
    /// disk may load scripts, and nothing else. None without Tiers::script_of.
    std::vector<ScriptFile> scripts() const;
    /// What a reader must know of what the page does not hold; empty where it holds all.
    std::string omissions() const;

  private:
    /// A view's blocks, and which of them the page takes.
    struct Choice {
        PlanesFile source;
        Directory directory;
        std::vector<bool> taken;  ///< of the directory's blocks
    };

    /// Blocks that lie in one script.
    struct Group {
        std::string script;
        std::vector<std::size_t> blocks;
    };

    static bool has_guess(const Choice& choice, std::size_t i);
    void take(Choice& choice, int tier, std::size_t& budget) const;
    std::vector<Group> groups_beside(const Choice& choice) const;
    FileAsBase64 taken_from(const Choice& choice) const;
    static nlohmann::json left_out(const Choice& choice);

    Tiers tiers_;
    std::vector<Choice> choices_;
};

/// JSON in an element of that id; no text in it can end the element.
std::string json_element(const std::string& id, const nlohmann::json& content);

}  // namespace zproof::planes
