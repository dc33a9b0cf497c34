#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstring>
#include <functional>
#include <iterator>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "reports/evidence.h"

namespace zproof {

namespace {

constexpr auto& finding_columns = table_columns<Finding>;
constexpr std::size_t most_digits = 32;
constexpr std::size_t most_row_bytes =
    std::tuple_size_v<decltype(table_columns<Finding>)> * (most_digits + 1);

char* write_cell(char* to, std::integral auto value) {
    to = std::to_chars(to, to + most_digits, value).ptr;
    *to = ',';
    return to + 1;
}

char* write_cell(char* to, PrimitiveId id) {
    if (id != PrimitiveId::none) return write_cell(to, static_cast<std::uint32_t>(id));
    return std::ranges::copy(std::string_view("none,"), to).out;
}

char* write_cell(char* to, PixelClass c) {
    to = std::ranges::copy(name_of(c), to).out;
    *to = ',';
    return to + 1;
}

template <class Value>
struct Column {
    char* write(char* to, Value value) { return write_cell(to, value); }
};

/// The last real number of a column and how it is written: what stands above is often the same.
template <std::floating_point Real>
class Column<Real> {
  public:
    /// Writes the number and a comma; returns what follows. The shortest digits that read back to the same
    /// bits; to_chars would tell -nan apart.
    char* write(char* to, Real value) {
        if (size_ == 0 || std::memcmp(&value, &value_, sizeof value) != 0) {
            value_ = value;
            char* const end = std::isnan(value) ? std::ranges::copy(std::string_view("nan"), digits_).out
                                                : std::to_chars(digits_, digits_ + most_digits, value).ptr;
            *end = ',';
            size_ = std::size_t(end + 1 - digits_);
        }
        std::memcpy(to, digits_, sizeof digits_);
        return to + size_;
    }

  private:
    Real value_{};
    std::size_t size_ = 0;
    char digits_[most_digits + 1] = {};
};

/// Writes rows, one after another.
class RowWriter {
  public:
    /// Writes at most most_row_bytes, of which the last may be written beyond; returns what follows.
    char* write(char* to, const Finding& finding) {
        write_cells(to, finding, std::make_index_sequence<std::tuple_size_v<decltype(columns_)>>{});
        to[-1] = '\n';
        return to;
    }

  private:
    template <std::size_t... i>
    void write_cells(char*& to, const Finding& finding, std::index_sequence<i...>) {
        ((to = std::get<i>(columns_).write(to, std::invoke(std::get<i>(finding_columns).get, finding))), ...);
    }

    template <class... Rows>
    static std::tuple<Column<ValueOf<const Finding, Rows>>...> columns_for(const std::tuple<Rows...>&);
    decltype(columns_for(finding_columns)) columns_;
};

std::string heading() {
    std::string names;
    std::apply([&](const auto&... column) { ((names += std::string(column.column()) + ","), ...); },
               finding_columns);
    names.back() = '\n';
    return names;
}

/// A piece of the file, made by one thread; a wave of them is in memory at a time.
constexpr std::size_t rows_in_piece = 1024, pieces_in_wave = 64, rows_at_once = 16;

std::string rows_of(std::span<const Finding> findings) {
    std::string text;
    std::array<char, most_row_bytes*(rows_at_once + 1)> room;
    RowWriter writer;
    for (; !findings.empty(); findings = findings.subspan(std::min(findings.size(), rows_at_once))) {
        char* end = room.data();
        for (const Finding& f : findings.first(std::min(findings.size(), rows_at_once)))
            end = writer.write(end, f);
        text.append(room.data(), end);
    }
    return text;
}

void write_wave(std::ostream& out, std::span<const Finding> findings) {
    std::array<std::string, pieces_in_wave> pieces;
    tbb::parallel_for(std::size_t{0}, (findings.size() + rows_in_piece - 1) / rows_in_piece,
                      [&](std::size_t i) {
                          const auto rows = findings.subspan(i * rows_in_piece);
                          pieces[i] = rows_of(rows.first(std::min(rows.size(), rows_in_piece)));
                      });
    for (const std::string& piece : pieces) out << piece;
}

}  // namespace

void write_findings(std::ostream& out, const Verdict& verdict) {
    out << heading();
    constexpr std::size_t wave = rows_in_piece * pieces_in_wave;
    for (std::span<const Finding> rest = verdict.findings; !rest.empty();
         rest = rest.subspan(std::min(rest.size(), wave)))
        write_wave(out, rest.first(std::min(rest.size(), wave)));
}

}  // namespace zproof
