#include "image_io/attribute_channels.h"

#include <string>

#include "frame/frame_error.h"
#include "image_io/samples.h"

namespace zproof::image_io {

namespace {

std::optional<ChannelPlace> place_in_part(const ImageFile& file, std::size_t part, std::string_view name) {
    const auto& channels = file.parts()[part].channels;
    const auto found = std::ranges::find(channels, name, &Channel::name);
    if (found == channels.end()) return std::nullopt;
    return ChannelPlace{int(part), int(found - channels.begin())};
}

/// In the part of the depths, else in the first that has it.
std::optional<ChannelPlace> place_of_channel(const ImageFile& file, int part_of_depths,
                                             std::string_view name) {
    if (const auto place = place_in_part(file, std::size_t(part_of_depths), name)) return place;
    for (std::size_t p = 0; p < file.parts().size(); ++p)
        if (const auto place = place_in_part(file, p, name)) return place;
    return std::nullopt;
}

/// "L." of "L.bary.u" and "" of "bary.u"; nothing of other names.
std::optional<std::string> layer_of(const std::string& name, std::string_view attribute_channel) {
    if (!name.ends_with(attribute_channel)) return std::nullopt;
    std::string layer = name.substr(0, name.size() - attribute_channel.size());
    return layer.empty() || layer.ends_with('.') ? std::optional(layer) : std::nullopt;
}

/// The layer that an attribute is taken from, by its first channel: that without a name, that of the depths,
/// or the first.
std::string layer_of(const ImageFile& file, const ChannelPlace& depths, Attribute attribute) {
    const auto first = std::ranges::find(attribute_channels, attribute, &AttributeChannel::attribute);
    const std::string& depth = file.channel(depths).name;
    const std::string of_depths = depth.substr(0, depth.rfind('.') + 1);
    std::optional<std::string> found;
    for (const Part& part : file.parts())
        for (const Channel& channel : part.channels) {
            const auto layer = layer_of(channel.name, first->name);
            if (layer && (!found || layer->empty() || (*layer == of_depths && !found->empty())))
                found = layer;
        }
    return found.value_or("");
}

void require_float(const ImageFile& file, const ChannelPlace& place, Resolution size) {
    const Channel& channel = file.channel(place);
    if (channel.sample != Sample::float32)
        throw FrameError(file.name() + ": channel '" + channel.name + "' is of type " +
                         name_of(channel.sample) + "; expected float");
    if (file.size_of(place.part) != size)
        throw FrameError(file.name() + ": channel '" + channel.name + "' has another size than the depths");
}

/// An attribute has all of its channels or none.
void require_whole(const ImageFile& file, const Attributes& attributes) {
    for (std::size_t c = 0; c < attribute_channels.size(); ++c)
        if (!attributes.has(c) && std::ranges::any_of(attribute_channels, [&](const AttributeChannel& other) {
                const auto place = std::size_t(&other - attribute_channels.data());
                return other.attribute == attribute_channels[c].attribute && attributes.has(place);
            }))
            throw FrameError(
                file.name() + ": channel '" + std::string(attribute_channels[c].name) +
                "' is missing, and the attribute's others are there; expected all of them or none");
}

}  // namespace

Attributes read_attributes(const ImageFile& file, const ChannelPlace& depths, Resolution size) {
    Attributes attributes;
    std::vector<WantedChannel> wanted;
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        const AttributeChannel& channel = attribute_channels[c];
        const auto place = place_of_channel(
            file, depths.part, layer_of(file, depths, channel.attribute) + std::string(channel.name));
        if (!place) continue;
        require_float(file, *place, size);
        Plane<float>& plane = attributes.planes[c] = Plane<float>(size);
        wanted.push_back({*place, [&plane](const SampleRow& row) {
                              spread_reals(
                                  row, plane.row(row.y).subspan(std::size_t(row.x)),
                                  [](float& to, const float& value) { std::memcpy(&to, &value, sizeof to); });
                          }});
    }
    require_whole(file, attributes);
    if (!wanted.empty()) file.read(wanted);
    return attributes;
}

}  // namespace zproof::image_io
