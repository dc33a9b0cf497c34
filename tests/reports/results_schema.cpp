#include "tests/reports/results_schema.h"

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "reports/result_fields.h"
#include "reports/waiver_status.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

/// Makes the schema of each type that it meets; those of records become definitions.
struct Definitions {
    Json all = Json::object();

    /// Of one value; it refers to definitions.
    template <class Value>
    Json of();

    template <class Record>
    void add_fields(Json& object);
};

Json of_type(const char* type) {
    Json schema;
    schema["type"] = type;
    return schema;
}

Json list_of(const Json& items) { return {{"type", "array"}, {"items", items}}; }

Json list_of(const Json& items, std::size_t count) {
    return {{"type", "array"}, {"minItems", count}, {"maxItems", count}, {"items", items}};
}

Json reference(const std::string& name) {
    Json to;
    to["$ref"] = "#/definitions/" + name;
    return to;
}

Json names_among(Json names) { return {{"type", "string"}, {"enum", std::move(names)}}; }

/// The object that holds the path's last key, with the keys before it as objects that are required.
Json& holder_of(Json& object, std::string_view path) {
    const std::size_t slash = path.find('/');
    if (slash == path.npos) return object;
    const std::string first(path.substr(0, slash));
    Json& required = object["required"];
    if (std::find(required.begin(), required.end(), first) == required.end()) required.push_back(first);
    Json& next = object["properties"][first];
    next["type"] = "object";
    return holder_of(next, path.substr(slash + 1));
}

std::string description_of(std::string_view meaning, const FieldFacts& facts) {
    std::string text(meaning);
    const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
    if (!facts.unit.empty()) add("in " + std::string(facts.unit));
    if (!facts.since.empty()) add("since " + std::string(facts.since));
    return text;
}

/// Beside a $ref draft 7 reads nothing else.
Json with_facts(Json schema, const std::string& description, const FieldFacts& facts) {
    if (description.empty() && facts.limits.empty()) return schema;
    const Json limits = facts.limits.empty() ? Json::object() : Json::parse(facts.limits);
    Json whole = Json::object();
    if (!description.empty()) whole["description"] = description;
    if (limits.contains("type")) schema = Json::object();
    if (schema.contains("$ref"))
        whole["allOf"] = Json::array({schema});
    else
        whole.update(schema);
    whole.update(limits);
    return whole;
}

/// What stands for something that may not be there.
Json or_null(const Json& schema) {
    Json either;
    either["anyOf"] = Json::array({schema, of_type("null")});
    return either;
}

template <class Record>
void Definitions::add_fields(Json& object) {
    object["type"] = "object";
    object["required"] = Json::array();
    visit_rows<Record>([&]<class Row>(const Row& row) {
        if constexpr (!is_field<Row>) {
            if (&row == static_cast<const void*>(&std::get<0>(fields<Record>))) {
                if (!row.meaning.empty()) object["description"] = row.meaning;
            } else {
                object["properties"][std::string(row.name)]["description"] = row.meaning;
            }
        } else {
            Json& holder = holder_of(object, row.name);
            const std::string key(row.name.substr(row.name.rfind('/') + 1));
            using Value = ValueOf<Record, Row>;
            Json schema = of<Value>();
            if constexpr (requires(Value value) { value.has_value(); })
                if (row.facts.presence != unless_empty) schema = or_null(schema);
            holder["properties"][key] =
                with_facts(std::move(schema), description_of(row.meaning, row.facts), row.facts);
            if (std::is_same_v<decltype(row.where), Always> && row.facts.since.empty() &&
                row.facts.presence != unless_empty)
                holder["required"].push_back(key);
        }
    });
}

template <class Form>
inline constexpr bool is_form = false;
template <class Form, class Value>
inline constexpr bool is_form<As<Form, Value>> = true;

template <class Form, class Value>
Json form_schema(const As<Form, Value>*) {
    if constexpr (std::is_same_v<Form, Bits>)
        return {{"type", "string"}, {"pattern", "^0x[0-9a-f]{8}$"}};
    else if constexpr (std::is_same_v<Form, Flag>)
        return of_type("boolean");
    else if constexpr (std::is_same_v<Form, JsonText>)
        return of_type("object");
    else if constexpr (std::is_same_v<Form, Sparse>)
        return {{"type", "object"}, {"additionalProperties", reference("count")}};
    else {
        Json names = Json::array();
        for (const AttributeChannel& channel : attribute_channels) names.push_back(channel.name);
        return names_among(names);
    }
}

Json counts_by_class() {
    Json required = Json::array(), properties = Json::object();
    for (const PixelClass c : Words<PixelClass>::values) {
        required.push_back(name_of(c));
        properties[std::string(name_of(c))] = reference("count");
    }
    return {{"type", "object"}, {"required", required}, {"properties", properties}};
}

Json waived_place(Definitions& definitions) {
    Json object;
    object["type"] = "object";
    object["required"] = {"kind"};
    object["properties"]["kind"] = names_among(waived_places);
    const auto add = [&](const auto& place) {
        Json one;
        definitions.add_fields<std::remove_cvref_t<decltype(place)>>(one);
        if (one.contains("properties")) object["properties"].update(one["properties"]);
    };
    add(Anywhere{}), add(AtTriangles{}), add(AtPairs{}), add(AtPixels{});
    return object;
}

template <class Value>
Json Definitions::of() {
    if constexpr (is_form<Value>) {
        return form_schema(static_cast<const Value*>(nullptr));
    } else if constexpr (std::is_same_v<Value, PrimitiveId>) {
        return reference("triangle");
    } else if constexpr (std::is_same_v<Value, Day>) {
        return reference("day");
    } else if constexpr (std::is_same_v<Value, PixelClass>) {
        return reference("class");
    } else if constexpr (std::is_same_v<Value, ClassCounts>) {
        return reference("counts");
    } else if constexpr (std::is_same_v<Value, BoundHistogram>) {
        return list_of(reference("count"), Value{}.size());
    } else if constexpr (std::is_same_v<Value, PictureDifferences>) {
        return {{"type", "object"}, {"additionalProperties", of<PictureDifference>()}};
    } else if constexpr (std::is_same_v<Value, decltype(Waiver::where)>) {
        return waived_place(*this);
    } else if constexpr (std::is_same_v<Value, std::map<std::string, std::uint64_t>>) {
        return {{"type", "object"}, {"additionalProperties", reference("count")}};
    } else if constexpr (std::is_floating_point_v<Value>) {
        return reference("number");
    } else if constexpr (std::is_integral_v<Value>) {
        return reference("count");
    } else if constexpr (std::is_enum_v<Value>) {
        Json names = Json::array();
        for (const Value value : Words<Value>::values) names.push_back(name_of(value));
        return names_among(names);
    } else if constexpr (is_list<Value>) {
        using Elements = decltype(elements_of<Value>(std::declval<Value&>()));
        return list_of(of<std::remove_cvref_t<std::tuple_element_t<0, Elements>>>(),
                       std::tuple_size_v<Elements>);
    } else if constexpr (is_vector<Value>) {
        return list_of(of<typename Value::value_type>());
    } else if constexpr (requires(Value value) { value.has_value(); }) {
        return of<typename Value::value_type>();
    } else if constexpr (is_record<Value>) {
        const std::string name(std::get<0>(fields<Value>).name);
        if (!all.contains(name)) {
            Json object;
            add_fields<Value>(object);
            all[name] = std::move(object);
        }
        return reference(name);
    } else {
        return of_type("string");
    }
}

void add_basic(Json& all) {
    all["count"] = {{"type", "integer"}, {"minimum", 0}};
    all["number"] = {
        {"description", "A number that reads back to the same bits, or a name for what JSON cannot write."},
        {"anyOf", Json::array({of_type("number"), names_among({"nan", "inf", "-inf"})})}};
    Json names = Json::array();
    for (const PixelClass c : Words<PixelClass>::values) names.push_back(name_of(c));
    all["class"] = names_among(names);
    all["counts"] = counts_by_class();
    all["day"] = {{"type", "string"}, {"pattern", "^[0-9]{4}-[0-9]{2}-[0-9]{2}$"}};
    all["triangle"] = {{"description", "Triangle index in the baked scene; null is background."},
                       {"anyOf", Json::array({{{"type", "integer"}, {"minimum", 0}, {"maximum", 4294967294}},
                                              of_type("null")})}};
}

/// Adds what rows do not tell: each waiver's state, and the views.
void add_the_rest(Json& schema, Definitions& definitions) {
    Json states = Json::array();
    using State = WaiverStatus::State;
    for (const State state :
         {State::expired, State::exceeded, State::unused, State::improved, State::in_use, State::not_asked})
        states.push_back(name_of(state));
    Json& waiver = definitions.all["waiver"];
    waiver["required"].push_back("state");
    waiver["properties"]["state"] = names_among(states);
    schema["required"].push_back("views");
    schema["properties"]["views"] = list_of(definitions.of<ViewResult>());
}

/// In one line, or as its elements in a line each where that is too long.
std::string text_of(const Json& json, std::size_t indent, std::size_t columns) {
    if (!json.is_structured() || json.empty()) return json.dump();
    std::string line, lines;
    for (const auto& [key, value] : json.items()) {
        const std::string name = json.is_object() ? Json(key).dump() + ": " : "";
        if (columns > 0)
            lines += (lines.empty() ? "\n" : ",\n") + std::string(indent + 2, ' ') + name +
                     text_of(value, indent + 2, columns);
        line += (line.empty() ? "" : ", ") + name + text_of(value, 0, 0);
    }
    const char* const ends = json.is_object() ? "{}" : "[]";
    const bool is_long = json.is_object() || json.front().is_structured();
    if (columns == 0 || !is_long || indent + line.size() < columns) return ends[0] + line + ends[1];
    return ends[0] + lines + "\n" + std::string(indent, ' ') + ends[1];
}

}  // namespace

std::string results_schema() {
    Json schema;
    schema["$schema"] = "http://json-schema.org/draft-07/schema#";
    schema["title"] = std::string("zproof results.json ") + Results::schema_version;
    Definitions definitions;
    add_basic(definitions.all);
    definitions.add_fields<Results>(schema);
    add_the_rest(schema, definitions);
    schema["definitions"] = std::move(definitions.all);
    constexpr std::size_t columns = 160;
    return text_of(schema, 0, columns) + "\n";
}

}  // namespace zproof
