#include "cli/attribute_remarks.h"

#include <algorithm>
#include <cctype>

#include "compare/attributes/attribute_check.h"
#include "frame/joined.h"
#include "program/nearest_word.h"

namespace zproof {
namespace {

/// "normal.x" of "ViewLayer.Normal.x": without its layer, and as attributes are written but for the axis.
std::string without_layer(const std::string& channel) {
    const std::size_t axis = channel.rfind('.');
    const std::size_t layer = axis == std::string::npos || axis == 0 ? axis : channel.rfind('.', axis - 1);
    std::string name = layer == std::string::npos ? channel : channel.substr(layer + 1);
    const auto end = name.begin() + std::ptrdiff_t(std::min(name.rfind('.'), name.size()));
    std::transform(name.begin(), end, name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return name;
}

bool is_attribute(const std::string& channel) {
    return std::ranges::any_of(attribute_channels, [&](const AttributeChannel& known) {
        return channel == known.name || channel.ends_with("." + std::string(known.name));
    });
}

}  // namespace

std::vector<std::string> attribute_remarks(const Scene& scene, const View& view, const Attributes& given,
                                           const Precision& precision) {
    std::vector<std::string> remarks = unjudged_attributes(scene, view, given, precision);
    const std::string judged = joined(judged_attributes(scene, view, given, precision), ", ",
                                      [](Attribute attribute) { return name_of(attribute); });
    if (!judged.empty()) remarks.insert(remarks.begin(), "attributes judged: " + judged);
    return remarks;
}

std::vector<std::string> misnamed_attributes(std::span<const std::string> channels) {
    std::vector<std::string> known, remarks;
    for (const AttributeChannel& channel : attribute_channels) known.emplace_back(channel.name);
    for (const std::string& channel : channels) {
        if (is_attribute(channel)) continue;
        const std::string meant = did_you_mean(without_layer(channel), known);
        if (!meant.empty()) remarks.push_back("channels not judged: '" + channel + "'" + meant);
    }
    return remarks;
}

}  // namespace zproof
