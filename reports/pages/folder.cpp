#include "reports/pages/folder.h"

#include <span>

#include "frame/whole_file.h"
#include "reports/pages/json.h"
#include "reports/pages/writers.h"
#include "reports/result_file.h"

namespace zproof::document {

namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& file, const std::string& text) {
    write_whole_file(file, std::as_bytes(std::span{text}));
}

void write_item(const fs::path& folder, const Table& table) {
    write_text(folder / (table.name + ".csv"), csv_of(table));
}
void write_item(const fs::path& folder, const Plot& plot) {
    write_text(folder / (plot.name + ".svg"), chart_svg(plot.chart));
}
void write_item(const fs::path& folder, const Picture& picture) {
    write_whole_file(folder / (picture.name + ".png"), picture.png);
}
void write_item(const fs::path& folder, const Drawing& drawing) {
    write_text(folder / (drawing.name + ".svg"), drawing.svg);
}

}  // namespace

void write_document(const fs::path& folder, const Document& document) {
    require_sound(document);
    for (const Section& section : document.sections)
        for (const Item& item : section.items)
            std::visit([&](const auto& one) { write_item(folder, one); }, item);
    write_text(folder / "study.json", json_of(document));
    write_text(folder / "study.html", page_of(document));
}

Document read_document(const fs::path& folder) {
    const std::string text = read_result(folder / "study.json", "a folder that 'zproof study' wrote");
    return document_from_json(text, [&](const std::string& name) {
        if (fs::path{name}.filename() != name)
            throw ReportError{"study.json: the file '" + name + "' lies outside of its folder"};
        return read_result(folder / name, "a picture that study.json names");
    });
}

}  // namespace zproof::document
