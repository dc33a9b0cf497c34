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
};

/// What a page takes of some views. Its base64 is made when the page is written.
class EmbeddedPlanes {
  public:
    /// `budget`: bytes of the page. Throws ReportError where a file is damaged.
    EmbeddedPlanes(std::vector<PlanesFile> files, const Tiers& tiers, std::size_t budget);

    bool has_planes(std::size_t view) const { return !choices_[view].taken.empty(); }
    /// The containers of what it takes; the headers of those that lack blocks name them in "leftOut".
    void append_to(Page& page) const;
    /// What a reader must know of what the page does not hold; empty where it holds all.
    std::string omissions() const;

  private:
    /// A view's blocks, and which of them the page takes.
    struct Choice {
        PlanesFile source;
        Directory directory;
        std::vector<bool> taken;  ///< of the directory's blocks
    };

    static bool has_guess(const Choice& choice, std::size_t i);
    static void take(Choice& choice, int tier, const Tiers& tiers, std::size_t& budget);
    static FileAsBase64 taken_from(const Choice& choice);
    static nlohmann::json left_out(const Choice& choice);

    std::vector<Choice> choices_;
};

/// JSON in an element of that id; no text in it can end the element.
std::string json_element(const std::string& id, const nlohmann::json& content);

}  // namespace zproof::planes
