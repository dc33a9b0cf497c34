/// A record's fields as rows, each declared once: its name in JSON, where its value stands, what it means.
/// What writes, reads or describes records visits the rows, and knows no field by itself.
#pragma once

#include <functional>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace zproof {

/// What is true of a field beside its name and its value.
struct FieldFacts {
    std::string_view unit{};
    std::string_view since{};   ///< results of zproof before that version may lack it; empty: none does
    std::string_view limits{};  ///< further keywords of its JSON schema: R"({"maxItems": 20})"
    std::string_view column{};  ///< its name in findings.csv, where it is another
    std::string_view record{};  ///< its name in numpy, where it is yet another
    enum class Presence { always, unless_empty } presence = Presence::always;
};

struct Always {
    template <class Record>
    constexpr bool operator()(const Record&) const {
        return true;
    }
};

/// Get: a pointer to a member, or a function. What it gives by reference is written and read; a value,
/// written.
template <class Get, class Where = Always>
struct Field {
    std::string_view name;  ///< "a/b": the key b of the object a
    Get get;
    std::string_view meaning;
    FieldFacts facts;
    Where where{};  ///< of a record: does it have the field?

    constexpr std::string_view column() const { return facts.column.empty() ? name : facts.column; }
    constexpr std::string_view record() const { return facts.record.empty() ? column() : facts.record; }
};

template <class Get>
constexpr Field<Get> field(std::string_view name, Get get, std::string_view meaning = {},
                           FieldFacts facts = {}) {
    return {name, get, meaning, facts};
}

template <class Where, class Get>
constexpr Field<Get, Where> field_where(Where where, std::string_view name, Get get,
                                        std::string_view meaning = {}, FieldFacts facts = {}) {
    return {name, get, meaning, facts, where};
}

/// What is true of an object: of a whole record where it is its first row, else of a key that has fields.
struct ObjectFacts {
    std::string_view name, meaning{};
};

/// The rows of a record, a tuple.
template <class Record>
inline constexpr std::tuple<> fields{};

template <class Record>
inline constexpr bool is_record = std::tuple_size_v<std::remove_const_t<decltype(fields<Record>)>> > 0;

template <class Row>
inline constexpr bool is_field = !std::is_same_v<Row, ObjectFacts>;

template <class Record, class Visit>
void visit_rows(const Visit& visit) {
    std::apply([&](const auto&... row) { (visit(row), ...); }, fields<Record>);
}

template <class Record, class Visit>
void visit_fields(const Visit& visit) {
    visit_rows<Record>([&]<class Row>(const Row& row) {
        if constexpr (is_field<Row>) visit(row);
    });
}

/// A member of a member.
template <class Outer, class Inner>
struct Path {
    Outer outer;
    Inner inner;

    template <class Record>
    constexpr decltype(auto) operator()(Record& record) const {
        return std::invoke(inner, std::invoke(outer, record));
    }
};

template <class Outer, class Inner>
constexpr Path<Outer, Inner> at(Outer outer, Inner inner) {
    return {outer, inner};
}

/// The rows of a member, as the record's own.
template <class Outer, class... Rows>
constexpr auto within(Outer outer, const std::tuple<Rows...>& rows) {
    return std::apply(
        [&](const auto&... row) {
            static_assert((std::is_same_v<decltype(row.where), Always> && ...));
            return std::tuple{field(row.name, at(outer, row.get), row.meaning, row.facts)...};
        },
        rows);
}

/// A value that stands in JSON in another form than its type's; Form is a name for it.
template <class Form, class Value>
struct As {
    Value& value;
};

template <class Form, class Get>
struct GetAs {
    Get get;

    template <class Record>
    constexpr auto operator()(Record& record) const {
        auto& value = std::invoke(get, record);
        return As<Form, std::remove_reference_t<decltype(value)>>{value};
    }
};

template <class Form, class Get>
constexpr GetAs<Form, Get> as(Get get) {
    return {get};
}

/// What the field of such a record has for a value.
template <class Record, class Row>
using ValueOf =
    std::remove_cvref_t<decltype(std::invoke(std::declval<const Row&>().get, std::declval<Record&>()))>;

/// The fields that are a number or a word each: the columns of a table.
template <class Record>
inline constexpr auto table_columns = std::apply(
    [](const auto&... row) {
        const auto column = []<class Row>(const Row& field) {
            using Value = ValueOf<Record, Row>;
            if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>)
                return std::tuple{field};
            else
                return std::tuple<>{};
        };
        return std::tuple_cat(column(row)...);
    },
    fields<Record>);

}  // namespace zproof
