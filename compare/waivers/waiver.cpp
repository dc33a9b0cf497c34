#include "compare/waivers/waiver.h"

#include <charconv>

namespace zproof {
namespace {

/// A whole number that fills its text; nothing else.
std::optional<unsigned> number(std::string_view text) {
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc{} && read.ptr == end ? std::optional{value} : std::nullopt;
}

std::string padded(unsigned value, std::size_t width) {
    const std::string digits = std::to_string(value);
    return std::string(width - std::min(width, digits.size()), '0') + digits;
}

}  // namespace

bool is_expired(const Waiver& waiver, Day today) {
    return std::chrono::sys_days{today} > std::chrono::sys_days{waiver.expires};
}

std::optional<Day> day_from(std::string_view text) {
    if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
    const auto year = number(text.substr(0, 4)), month = number(text.substr(5, 2)),
               day = number(text.substr(8, 2));
    if (!year || !month || !day) return std::nullopt;
    const Day found{std::chrono::year{int(*year)}, std::chrono::month{*month}, std::chrono::day{*day}};
    return found.ok() ? std::optional{found} : std::nullopt;
}

std::string in_words(Day day) {
    return padded(unsigned(int(day.year())), 4) + "-" + padded(unsigned(day.month()), 2) + "-" +
           padded(unsigned(day.day()), 2);
}

}  // namespace zproof
