#include "reports/pages/document.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "image_io/image_io.h"

namespace zproof::document {

namespace {

bool is_file_stem(const std::string& name) {
    const auto is_safe = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    };
    return !name.empty() && name.size() <= 200 && name.front() != '.' && std::ranges::all_of(name, is_safe);
}

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
    throw std::logic_error{"document, " + place + ": " + what};
}

void require_sound(const Table& table) {
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        if (table.rows[i].size() != table.columns.size())
            refuse("table '" + table.name + "', row " + std::to_string(i),
                   std::to_string(table.rows[i].size()) + " cells, expected one for each of " +
                       std::to_string(table.columns.size()) + " columns");
}

void require_sound(const Picture& picture) {
    if (picture.png.empty()) refuse("picture '" + picture.name + "'", "no pixels; use picture_of()");
}

void require_sound(const Plot&) {}
void require_sound(const Drawing&) {}

}  // namespace

Picture picture_of(std::string name, std::string caption, const Plane<Rgb8>& pixels) {
    return {std::move(name), std::move(caption), "", encode_png(pixels)};
}

const std::string& name_of(const Item& item) {
    return std::visit([](const auto& one) -> const std::string& { return one.name; }, item);
}

const std::string& caption_of(const Item& item) {
    return std::visit([](const auto& one) -> const std::string& { return one.caption; }, item);
}

void require_sound(const Document& document) {
    std::set<std::string> taken{"study"};
    for (const Section& section : document.sections)
        for (const Item& item : section.items) {
            const std::string& name = name_of(item);
            if (!is_file_stem(name))
                refuse("section '" + section.heading + "'",
                       "'" + name + "' is no file stem: lower-case letters, digits, '-', '_', '.'");
            if (!taken.insert(name).second)
                refuse("section '" + section.heading + "'", "the name '" + name + "' is used twice");
            std::visit([](const auto& one) { require_sound(one); }, item);
        }
}

}  // namespace zproof::document
