#include <charconv>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <type_traits>
#include <utility>

#include "reports/json.h"
#include "reports/result_fields.h"
#include "reports/waiver_status.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

/// Any value of a row, as its type or its form has it in JSON.
template <class Value>
Json json_of(const Value& value);

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(shortest(value)); }

/// The double whose shortest decimal is the float's.
Json number(float value) {
    const std::string text = shortest(value);
    double same = 0;
    std::from_chars(text.data(), text.data() + text.size(), same);
    return number(same);
}

Json& at_path(Json& object, std::string_view path) {
    const std::size_t slash = path.find('/');
    Json& next = object[std::string(path.substr(0, slash))];
    return slash == path.npos ? next : at_path(next, path.substr(slash + 1));
}

template <class Value>
bool is_empty(const Value& value) {
    if constexpr (requires { value.has_value(); })
        return !value.has_value();
    else if constexpr (std::is_same_v<Value, BoundHistogram>)
        return value == Value{};
    else if constexpr (requires { value.empty(); })
        return value.empty();
    else
        return false;
}

template <class Record>
void write_fields(Json& object, const Record& record) {
    visit_fields<Record>([&](const auto& field) {
        const auto& value = std::invoke(field.get, record);
        if (!field.where(record) || (field.facts.presence == unless_empty && is_empty(value))) return;
        at_path(object, field.name) = json_of(value);
    });
}

Json special(PrimitiveId primitive) {
    return primitive == PrimitiveId::none ? Json(nullptr) : Json(static_cast<std::uint32_t>(primitive));
}

Json special(Day day) { return in_words(day); }
Json special(const As<Bits, const float>& as) { return hex_bits(as.value); }
Json special(const As<Channel, const std::size_t>& as) { return attribute_channels[as.value].name; }
Json special(const As<JsonText, const std::string>& as) { return Json::parse(as.value); }
template <class Choice>
Json special(const As<Flag, const Choice>& as) {
    return as.value == Choice{1};
}

Json special(const ClassCounts& counts) {
    Json object = Json::object();
    for (std::size_t i = 0; i < counts.size(); ++i) object[std::string(name_of(PixelClass(i)))] = counts[i];
    return object;
}

Json special(const As<Sparse, const ClassCounts>& as) {
    Json object = Json::object();
    for (std::size_t i = 0; i < as.value.size(); ++i)
        if (as.value[i] > 0) object[std::string(name_of(PixelClass(i)))] = as.value[i];
    return object;
}

/// Classes without a pixel are left out.
Json special(const PictureDifferences& differences) {
    Json object = Json::object();
    for (std::size_t i = 0; i < differences.size(); ++i)
        if (differences[i].pixels > 0) object[std::string(name_of(PixelClass(i)))] = json_of(differences[i]);
    return object;
}

Json special(const decltype(Waiver::where)& where) {
    Json object;
    object["kind"] = waived_places[where.index()];
    std::visit([&](const auto& place) { write_fields(object, place); }, where);
    return object;
}

template <class Value>
Json json_of(const Value& value) {
    if constexpr (requires { special(value); }) {
        return special(value);
    } else if constexpr (std::is_floating_point_v<Value>) {
        return number(value);
    } else if constexpr (std::is_enum_v<Value>) {
        return name_of(value);
    } else if constexpr (is_record<Value>) {
        Json object = Json::object();
        write_fields(object, value);
        return object;
    } else if constexpr (requires { value.has_value(); }) {
        return value ? json_of(*value) : Json(nullptr);
    } else if constexpr (is_list<Value>) {
        return std::apply([](const auto&... element) { return Json::array({json_of(element)...}); },
                          elements_of<Value>(value));
    } else if constexpr (is_vector<Value>) {
        Json list = Json::array();
        for (const auto& element : value) list.push_back(json_of(element));
        return list;
    } else {
        return value;
    }
}

/// All of it, with those views.
Json root_object(const Results& results, Json views) {
    Json root = json_of(results);
    Json& waivers = root["waivers"]["list"];
    const std::vector<WaiverStatus> statuses = waiver_statuses(results);
    for (std::size_t i = 0; i < statuses.size(); ++i) waivers[i]["state"] = name_of(statuses[i].state);
    root["views"] = std::move(views);
    return root;
}

std::string text_of(const Json& value) { return value.dump(1, ' ', false, Json::error_handler_t::replace); }

/// A view as an element of the root's last array: its lines stand two steps further in. A line break stands
/// between tokens only.
std::string element_text(const ViewResult& view) {
    std::string text = "\n  ";
    for (const char c : text_of(json_of(view))) {
        text += c;
        if (c == '\n') text += "  ";
    }
    return text;
}

}  // namespace

void write_json(const TextSink& out, const Results& results) {
    constexpr std::string_view end = "]\n}";
    std::string text = text_of(root_object(results, Json::array()));
    text.resize(text.size() - end.size());
    out(text);
    for (const ViewResult& view : results.views)
        out((&view == results.views.data() ? "" : ",") + element_text(view));
    out((results.views.empty() ? "" : "\n ") + std::string{end} + "\n");
}

std::string to_json(const Results& results) {
    return collected([&](const TextSink& out) { write_json(out, results); });
}

std::string waivers_as_json(const std::vector<Waiver>& waivers) { return text_of(json_of(waivers)); }

std::string to_message_pack(const Results& results) {
    std::string bytes;
    Json::to_msgpack(root_object(results, json_of(results.views)), bytes);
    return bytes;
}

}  // namespace zproof
