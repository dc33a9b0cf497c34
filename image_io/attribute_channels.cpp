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

Attributes read_attributes(const ImageFile& file, int part_of_depths, Resolution size) {
    Attributes attributes;
    std::vector<WantedChannel> wanted;
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        const auto place = place_of_channel(file, part_of_depths, attribute_channels[c].name);
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
