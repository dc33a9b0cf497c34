// docs/texture-filters.md holds the definition card of every method, word for word, in the catalogue's order.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "filters/methods/catalogue.h"

namespace zproof::texture {
namespace {

std::string cards() {
    std::ostringstream text;
    for (const Method& method : methods())
        text << "\n### " << method.name << "\n\n- Footprint: " << method.card.footprint
             << "\n- LOD: " << method.card.lod << "\n- Taps: " << method.card.taps
             << "\n- Source: " << method.card.source << "\n";
    return text.str();
}

/// What the page says between its heading "Cards" and the next one.
std::string cards_on_the_page() {
    std::ifstream file{ZPROOF_SOURCE_DIR "/docs/texture-filters.md"};
    std::stringstream page;
    page << file.rdbuf();
    const std::string text = page.str(), heading = "\n## Cards\n";
    const std::size_t begin = text.find(heading);
    if (begin == std::string::npos) return "";
    const std::size_t from = begin + heading.size();
    return text.substr(from, text.find("\n## ", from) - from);
}

/// A word per line, wherever the page breaks its lines.
std::string words_of(const std::string& text) {
    std::istringstream words{text};
    std::string folded;
    for (std::string word; words >> word;) folded += word + "\n";
    return folded;
}

TEST(DefinitionCards, AreOnTheirPage) {
    const std::string page = cards_on_the_page();
    EXPECT_EQ(words_of(page), words_of(cards())) << "docs/texture-filters.md, below '## Cards', must read:\n"
                                                 << cards();
}

}  // namespace
}  // namespace zproof::texture
