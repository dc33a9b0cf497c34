#include "program/settings/setting.h"

namespace zproof {

std::span<const Setting> known_settings() {
    using enum Setting::Kind;
    static const std::vector<Setting> all{
        {"scenes", paths},
        {"models", path},
        {"renderer", text},
        {"precision", text},
        {"convention", text},
        {"channels", text},
        {"oracle", list},
        {"require", list},
        {"time-limit", number, {1, 86400, 600}},
        {"width", number, {1, 32768, 1920}},
        {"height", number, {1, 32768, 1080}},
        {"threads", number, {1, 1024, 4}},
        {"isa", text},
        {"out", path},
        {"report", list},
        {"pictures", flag},
        {"evidence", text},
        {"waivers", path},
        {"strict", flag},
        {"now", text},
        {"shard", text},
        {"color", text},
        {"progress", text},
    };
    return all;
}

std::string in_words(const WholeRange& range) {
    return "expected a whole number from " + std::to_string(range.least) + " to " +
           std::to_string(range.most);
}

std::vector<std::string> setting_names() {
    std::vector<std::string> names;
    for (const Setting& setting : known_settings()) names.push_back(setting.name);
    return names;
}

std::string environment_name(const Setting& setting) {
    std::string name = "ZPROOF_";
    for (const char c : setting.name) name += c == '-' ? '_' : char(c - 'a' + 'A');
    return name;
}

std::string option_name(const std::string& setting) { return setting == "scenes" ? "SCENE" : "--" + setting; }

}  // namespace zproof
