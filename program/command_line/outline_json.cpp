#include "program/command_line/outline_json.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace zproof {

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Candidates, words, paths, listing)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OutlineOption, names, takes, choices, kind, description, default_value,
                                   candidates)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OutlineCommand, path, description, examples, footer, options, positionals,
                                   commands)

std::string json_of(const OutlineCommand& outline) { return Json(outline).dump() + "\n"; }

OutlineCommand outline_from(const std::string& json) {
    try {
        return Json::parse(json).get<OutlineCommand>();
    } catch (const Json::exception& e) {
        throw std::runtime_error{std::string{"no outline of a command line: "} + e.what()};
    }
}

}  // namespace zproof
