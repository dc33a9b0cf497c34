#include "reports/pages/json.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/result_file.h"
#include "reports/whole_number.h"
#include "reports/wording.h"

namespace zproof::document {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity and no NaN; a plain string would be text.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json{{"number", shortest(value)}}; }

double number(const Json& json) {
    if (json.is_number()) return json.get<double>();
    const std::string word = json.at("number");
    if (word == "inf") return std::numeric_limits<double>::infinity();
    if (word == "-inf") return -std::numeric_limits<double>::infinity();
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    throw ReportError{"study.json: expected the number \"nan\", \"inf\" or \"-inf\", found \"" + word + "\""};
}

Json json_of(const Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return printable(*text);
    if (const auto* whole = std::get_if<std::int64_t>(&cell)) return *whole;
    return number(std::get<double>(cell));
}

/// A whole number stays one: doubles are written with a point or an exponent.
Cell cell_of(const Json& json) {
    if (json.is_string()) return json.get<std::string>();
    if (json.is_number_integer()) return whole_number<std::int64_t>(json);
    return number(json);
}

Json json_of(const Table& table) {
    Json columns = Json::array(), rows = Json::array();
    for (const Column& c : table.columns)
        columns.push_back({{"title", c.title}, {"unit", c.unit}, {"meaning", c.meaning}});
    for (const Row& row : table.rows) {
        Json cells = Json::array();
        for (const Cell& cell : row) cells.push_back(json_of(cell));
        rows.push_back(cells);
    }
    return {{"kind", "table"},    {"name", table.name}, {"caption", table.caption},
            {"columns", columns}, {"rows", rows},       {"shown", table.shown}};
}

Table table_of(const Json& json) {
    Table table{json.at("name"), json.at("caption"), {}, {}, whole_number<std::size_t>(json.at("shown"))};
    for (const Json& c : json.at("columns"))
        table.columns.push_back({c.at("title"), c.at("unit"), c.at("meaning")});
    for (const Json& cells : json.at("rows")) {
        table.rows.emplace_back();
        for (const Json& cell : cells) table.rows.back().push_back(cell_of(cell));
    }
    return table;
}

Json json_of(const ChartAxis& axis) {
    return {{"title", axis.title},
            {"scale", axis.scale == Scale::linear ? "linear" : "logarithmic"},
            {"names", axis.names},
            {"notes", axis.notes},
            {"strengths", axis.strengths}};
}

ChartAxis axis_of(const Json& json) {
    return {json.at("title"), json.at("scale") == "linear" ? Scale::linear : Scale::logarithmic,
            json.at("names"), json.value("notes", std::vector<std::string>{}),
            json.value("strengths", std::vector<double>{})};
}

/// Words of enumerations, in their order.
constexpr std::array style_words{"marked", "muted", "quiet"};
constexpr std::array joining_words{"points", "line", "steps"};

template <class Enum, std::size_t Count>
Enum meant(const Json& json, const std::array<const char*, Count>& words) {
    const std::string word = json;
    for (std::size_t i = 0; i < Count; ++i)
        if (word == words[i]) return Enum(i);
    throw ReportError{"study.json: '" + word + "' is no word of a chart"};
}

Json json_of(const Series& series) {
    Json points = Json::array();
    for (const auto& [x, y] : series.points) points.push_back(Json::array({number(x), number(y)}));
    return {{"name", series.name},
            {"style", style_words.at(std::size_t(series.style))},
            {"joining", joining_words.at(std::size_t(series.joining))},
            {"points", points}};
}

Series series_of(const Json& json) {
    Series series{json.at("name"),
                  {},
                  meant<SeriesStyle>(json.at("style"), style_words),
                  meant<Joining>(json.at("joining"), joining_words)};
    for (const Json& point : json.at("points"))
        series.points.emplace_back(number(point.at(0)), number(point.at(1)));
    return series;
}

Json json_of(const Plot& plot) {
    Json series = Json::array();
    for (const Series& one : plot.chart.series) series.push_back(json_of(one));
    return {{"kind", "chart"},           {"name", plot.name},          {"caption", plot.caption},
            {"title", plot.chart.title}, {"x", json_of(plot.chart.x)}, {"y", json_of(plot.chart.y)},
            {"series", series},          {"file", plot.name + ".svg"}};
}

Plot plot_of(const Json& json) {
    Plot plot{json.at("name"),
              json.at("caption"),
              {json.at("title"), axis_of(json.at("x")), axis_of(json.at("y")), {}}};
    for (const Json& one : json.at("series")) plot.chart.series.push_back(series_of(one));
    return plot;
}

Json json_of(const Picture& picture) {
    return {{"kind", "picture"},
            {"name", picture.name},
            {"caption", picture.caption},
            {"group", picture.group},
            {"file", picture.name + ".png"}};
}

Picture picture_of(const Json& json, const ReadFile& read_file) {
    const std::string bytes = read_file(json.at("file"));
    const auto* begin = reinterpret_cast<const std::byte*>(bytes.data());
    return {json.at("name"), json.at("caption"), json.at("group"), {begin, begin + bytes.size()}};
}

Json json_of(const Drawing& drawing) {
    return {{"kind", "drawing"},
            {"name", drawing.name},
            {"caption", drawing.caption},
            {"file", drawing.name + ".svg"}};
}

Item item_of(const Json& json, const ReadFile& read_file) {
    const std::string kind = json.at("kind");
    if (kind == "table") return table_of(json);
    if (kind == "chart") return plot_of(json);
    if (kind == "picture") return picture_of(json, read_file);
    if (kind == "drawing") return Drawing{json.at("name"), json.at("caption"), read_file(json.at("file"))};
    throw ReportError{"study.json: an item of kind '" + kind +
                      "', expected table, chart, picture or drawing"};
}

}  // namespace

std::string json_of(const Document& document) {
    Json sections = Json::array();
    for (const Section& section : document.sections) {
        Json items = Json::array();
        for (const Item& item : section.items)
            items.push_back(std::visit([](const auto& one) { return json_of(one); }, item));
        sections.push_back(
            {{"heading", section.heading}, {"paragraphs", section.paragraphs}, {"items", items}});
    }
    const Json whole{{"schema_version", Document::schema_version},
                     {"title", document.title},
                     {"command", document.command},
                     {"version", document.version},
                     {"introduction", document.introduction},
                     {"sections", sections}};
    return whole.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Document document_from_json(const std::string& text, const ReadFile& read_file) try {
    const Json json = Json::parse(text);
    const std::string version = json.at("schema_version");
    if (!version.starts_with("1."))
        throw ReportError{"study.json: schema_version is " + version +
                          ", this zproof reads 1.x; use the zproof that wrote it"};
    Document document{json.at("title"), json.at("command"), json.at("version"), json.at("introduction"), {}};
    for (const Json& one : json.at("sections")) {
        Section section{one.at("heading"), one.at("paragraphs"), {}};
        for (const Json& item : one.at("items")) section.items.push_back(item_of(item, read_file));
        document.sections.push_back(std::move(section));
    }
    return document;
} catch (const Json::exception& e) {
    throw ReportError{"study.json: " + json_fault(e)};
}

}  // namespace zproof::document
