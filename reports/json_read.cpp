#include <algorithm>
#include <bit>
#include <charconv>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/json.h"
#include "reports/result_fields.h"
#include "reports/result_file.h"
#include "reports/whole_number.h"

namespace zproof {

namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& why) { throw ReportError("results.json: " + why); }

double number(const Json& json) {
    if (!json.is_string()) return json.get<double>();
    const std::string& text = json.get_ref<const std::string&>();
    if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "-inf") return -std::numeric_limits<double>::infinity();
    refuse("expected a number, \"nan\", \"inf\" or \"-inf\", found \"" + text + "\"");
}

float float_from_bits(const std::string& text) {
    std::uint32_t bits = 0;
    const char* const end = text.data() + text.size();
    if (text.size() != 10 || !text.starts_with("0x") ||
        std::from_chars(text.data() + 2, end, bits, 16).ptr != end)
        refuse("expected the bits of a float32 such as 0x3f800000, found \"" + text + "\"");
    return std::bit_cast<float>(bits);
}

/// Any value of a row, from what its type or its form has in JSON.
template <class Value>
void read(const Json& json, Value& value);

template <class Value>
Value read_as(const Json& json) {
    Value value{};
    read(json, value);
    return value;
}

template <class Enum>
Enum named(const std::string& name) {
    for (const Enum value : Words<Enum>::values)
        if (name_of(value) == name) return value;
    refuse("no " + std::string(Words<Enum>::noun) + " is named \"" + name + "\"");
}

/// What stands under the key, or under the key of a key; nullptr where nothing does.
const Json* found(const Json& object, std::string_view path) {
    const std::size_t slash = path.find('/');
    const auto next = object.find(path.substr(0, slash));
    if (next == object.end()) return nullptr;
    return slash == path.npos ? &*next : found(*next, path.substr(slash + 1));
}

/// Throws nlohmann's exception where nothing stands there.
const Json& at_path(const Json& object, std::string_view path) {
    const std::size_t slash = path.find('/');
    const Json& next = object.at(std::string(path.substr(0, slash)));
    return slash == path.npos ? next : at_path(next, path.substr(slash + 1));
}

/// What is left out where it is empty is no null.
template <class Value>
void read_what_is_there(const Json& json, Value& value) {
    if constexpr (requires { value.has_value(); })
        read(json, value.emplace());
    else
        read(json, value);
}

/// Fields that others tell are passed over. What an older version, or an empty value, leaves out stays as it
/// is.
template <class Record>
void read_fields(const Json& json, Record& record) {
    visit_fields<Record>([&](const auto& field) {
        using Value = decltype(std::invoke(field.get, record));
        if constexpr (is_read<Value>) {
            if (!field.where(record)) return;
            auto&& value = std::invoke(field.get, record);
            if (field.facts.since.empty() && field.facts.presence != unless_empty)
                read(at_path(json, field.name), value);
            else if (const Json* const there = found(json, field.name))
                read_what_is_there(*there, value);
        }
    });
}

void special(const Json& json, PrimitiveId& id) {
    id = json.is_null() ? PrimitiveId::none : PrimitiveId(whole_number<std::uint32_t>(json));
}

void special(const Json& json, Day& day) {
    const std::string text = json;
    const auto found = day_from(text);
    if (!found) refuse("expected a day such as 2026-04-10, found \"" + text + "\"");
    day = *found;
}

void special(const Json& json, As<Bits, float>& as) { as.value = float_from_bits(json); }

void special(const Json& json, As<Channel, std::size_t>& as) {
    const std::string name = json;
    const auto channel = std::ranges::find(attribute_channels, name, &AttributeChannel::name);
    if (channel == attribute_channels.end()) refuse("no channel is named \"" + name + "\"");
    as.value = std::size_t(channel - attribute_channels.begin());
}

void special(const Json& json, As<JsonText, std::string>& as) { as.value = json.dump(); }

template <class Choice>
void special(const Json& json, As<Flag, Choice>& as) {
    as.value = Choice{json.get<bool>()};
}

void special(const Json& json, ClassCounts& counts) {
    for (std::size_t i = 0; i < counts.size(); ++i)
        read(json.at(std::string(name_of(PixelClass(i)))), counts[i]);
}

void special(const Json& json, As<Sparse, ClassCounts>& as) {
    for (const auto& [name, pixels] : json.items())
        read(pixels, as.value[std::size_t(named<PixelClass>(name))]);
}

void special(const Json& json, PictureDifferences& differences) {
    for (const auto& [name, one] : json.items()) read(one, differences[std::size_t(named<PixelClass>(name))]);
}

void special(const Json& json, BoundHistogram& bins) {
    if (json.size() != bins.size())
        refuse("expected a histogram of " + std::to_string(bins.size()) + " bins");
    for (std::size_t i = 0; i < bins.size(); ++i) read(json.at(i), bins[i]);
}

void special(const Json& json, std::map<std::string, std::uint64_t>& counts) {
    for (const auto& [name, count] : json.items()) read(count, counts[name]);
}

/// The alternative of that number; a kind that nobody knows is the first.
template <std::size_t kind = 0>
void read_place(const Json& json, const std::string& name, decltype(Waiver::where)& where) {
    if constexpr (kind < waived_places.size()) {
        if (name != waived_places[kind]) return read_place<kind + 1>(json, name, where);
        read_fields(json, where.emplace<kind>());
    }
}

void special(const Json& json, decltype(Waiver::where)& where) { read_place(json, json.at("kind"), where); }

/// Candidate, reference and the oracles that were compared have a row and a column each; none has where
/// nothing was judged.
void require_all_compared(const ViewResult& v) {
    const auto& same = v.id_agreement.same;
    const std::size_t frames = 2 + std::size_t(std::ranges::count(v.oracles, "", &OracleResult::absent));
    const auto has_all = [&](const std::vector<std::uint64_t>& row) { return row.size() == frames; };
    if (!same.empty() && (same.size() != frames || !std::ranges::all_of(same, has_all)))
        refuse("expected an id_agreement of " + std::to_string(frames) + " rows and columns");
}

template <class Value>
void read(const Json& json, Value& value) {
    if constexpr (requires { special(json, value); }) {
        special(json, value);
    } else if constexpr (std::is_floating_point_v<Value>) {
        value = Value(number(json));
    } else if constexpr (std::is_integral_v<Value>) {
        value = whole_number<Value>(json);
    } else if constexpr (std::is_enum_v<Value>) {
        value = named<Value>(json);
    } else if constexpr (is_record<Value>) {
        read_fields(json, value);
    } else if constexpr (is_list<Value>) {
        std::size_t i = 0;
        std::apply([&](auto&... element) { (read(json.at(i++), element), ...); }, elements_of<Value>(value));
    } else if constexpr (is_vector<Value>) {
        if (!json.is_array()) refuse(std::string("expected a list, found ") + json.type_name());
        for (const Json& element : json) value.push_back(read_as<typename Value::value_type>(element));
    } else if constexpr (requires { value.has_value(); }) {
        value = json.is_null() ? Value{} : read_as<typename Value::value_type>(json);
    } else {
        json.get_to(value);
    }
}

ViewResult view(const Json& json) {
    auto view = read_as<ViewResult>(json);
    require_all_compared(view);
    return view;
}

void require_known_version(const std::string& version) {
    const std::string ours = Results::schema_version;
    const std::string major = ours.substr(0, ours.find('.') + 1);
    if (!version.starts_with(major))
        refuse("schema_version is " + version + ", this zproof reads " + major +
               "x; use the zproof that wrote it");
}

/// `views`: those that are no longer in `root`.
Results results_from(const Json& root, std::vector<ViewResult> views) {
    require_known_version(root.at("schema_version"));
    auto results = read_as<Results>(root);
    results.views = std::move(views);
    for (const Json& one : root.at("views")) results.views.push_back(view(one));
    return results;
}

/// What is wrong with view number `i`, and where.
std::string fault_in_view(const Json::exception& e, std::size_t i) {
    const std::string fault = json_fault(e), place = "(/views/" + std::to_string(i);
    return place + (fault.starts_with("(/") ? fault.substr(1) : ") " + fault);
}

/// Takes each view from the parser as soon as it is read: all of them as JSON would take many times the room.
class ViewReader {
  public:
    /// The parser's callback; false: the parser forgets what it has read.
    bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
        if (depth == 1 && event == Json::parse_event_t::key) key_ = parsed;
        if (depth == 1 && event == Json::parse_event_t::value && key_ == "schema_version")
            require_known_version(parsed);
        if (depth != 2 || event != Json::parse_event_t::object_end || key_ != "views") return true;
        take(Json(std::move(parsed)));  // without the parser's array around it, which is always at 0
        return false;
    }

    std::vector<ViewResult> views;

  private:
    void take(const Json& one) {
        try {
            views.push_back(view(one));
        } catch (const Json::exception& e) {
            refuse(fault_in_view(e, views.size()));
        }
    }

    std::string key_;  ///< of the root, that the parser is at
};

}  // namespace

Results results_from_json(const std::string& text) try {
    ViewReader reader;
    const Json root = Json::parse(text, std::ref(reader));
    return results_from(root, std::move(reader.views));
} catch (const Json::exception& e) {
    refuse(json_fault(e));
}

Results results_from_message_pack(const std::string& bytes) try {
    return results_from(Json::from_msgpack(bytes), {});
} catch (const Json::exception& e) {
    refuse(json_fault(e));
}

}  // namespace zproof
