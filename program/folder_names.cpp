#include "program/folder_names.h"

#include <algorithm>

namespace zproof {
namespace {

bool is_letter_or_digit(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

std::string in_lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), lower);
    return text;
}

}  // namespace

std::string safe_name(const std::string& text) {
    std::string safe = text.substr(0, 100);
    for (char& c : safe)
        if (!is_letter_or_digit(c) && c != '-' && c != '_' && c != '.') c = '_';
    if (safe.empty()) return "_";
    if (safe.front() == '.') safe.front() = '_';
    return safe;
}

std::string FolderNames::next(const std::string& text) {
    const std::string wanted = safe_name(text);
    std::string name = wanted;
    for (int i = 2; !taken_.insert(in_lower_case(name)).second; ++i) name = wanted + "-" + std::to_string(i);
    return name;
}

void FolderNames::take(const std::string& name) { taken_.insert(in_lower_case(name)); }

}  // namespace zproof
