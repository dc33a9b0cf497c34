/// What a study found, as a document: words, tables, charts and pictures in reading order. A study's report
/// fills one, and every writer beside this file shows it: nothing here knows what was studied.
///
/// All text is plain UTF-8; writers escape it. Names are file stems: NAME.csv, NAME.svg, NAME.png.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "frame/picture.h"
#include "frame/plane.h"
#include "reports/pages/chart.h"

namespace zproof::document {

using Cell = std::variant<std::string, std::int64_t, double>;  ///< a double may be infinite or NaN
using Row = std::vector<Cell>;

struct Column {
    std::string title;
    std::string unit;     ///< "px"; empty for none
    std::string meaning;  ///< a sentence for the page; may be empty
    bool operator==(const Column&) const = default;
};

struct Table {
    std::string name, caption;
    std::vector<Column> columns;
    std::vector<Row> rows;  ///< each as long as columns
    /// The terminal and the page show the first so many rows and say how many there are; CSV and JSON hold
    /// all. A report therefore puts the rows that matter most first.
    std::size_t shown = 40;
    bool operator==(const Table&) const = default;
};

struct Plot {
    std::string name, caption;
    Chart chart;
    bool operator==(const Plot&) const = default;
};

/// Pixels as they are.
struct Picture {
    std::string name, caption;
    std::string group;  ///< pictures of one group and section stand side by side, magnified alike; or empty
    std::vector<std::byte> png;  ///< the file's bytes: picture_of() makes them
    bool operator==(const Picture&) const = default;
};

/// Lines and shapes.
struct Drawing {
    std::string name, caption;
    std::string svg;  ///< a whole file, without scripts or references to other files
    bool operator==(const Drawing&) const = default;
};

using Item = std::variant<Table, Plot, Picture, Drawing>;

struct Section {
    std::string heading;
    std::vector<std::string> paragraphs;
    std::vector<Item> items;
    bool operator==(const Section&) const = default;
};

struct Document {
    static constexpr const char* schema_version = "1.0";
    std::string title;
    std::string command, version;           ///< as typed; "0.2.0"
    std::vector<std::string> introduction;  ///< paragraphs: what was asked, and the answer in short
    std::vector<Section> sections;
    bool operator==(const Document&) const = default;
};

/// The picture as an item without a group.
Picture picture_of(std::string name, std::string caption, const Plane<Rgb8>& pixels);

const std::string& name_of(const Item& item);
const std::string& caption_of(const Item& item);

/// Throws std::logic_error, naming the place, where a row has another length than its table's columns, a name
/// is used twice or is no file stem (lower-case letters, digits, '-', '_', '.'; the first no '.'), or a
/// picture has no pixels. Every writer may rely on what this holds; write_document() asks it.
void require_sound(const Document& document);

}  // namespace zproof::document
