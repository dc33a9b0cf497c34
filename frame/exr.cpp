#include "frame/exr.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "frame/exr_encode.h"
#include "frame/frame_error.h"
#include "frame/frame_size.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

/// An open OpenEXR file and the name that errors give it.
struct ExrFile {
    std::string name;
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::ImageSpec spec;
};

ExrFile open_exr(const std::filesystem::path& file) {
    const std::string name = file.string();
    if (!std::filesystem::is_regular_file(file))
        throw FrameError(name + ": no such file; expected an OpenEXR frame");
    // Created by format, not by file name: the contract says OpenEXR, whatever the extension says.
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec spec;
    if (!input || !input->open(name, spec)) {
        const std::string reason = input ? input->geterror() : OIIO::geterror();
        throw FrameError(name + ": not a readable OpenEXR file: " + reason);
    }
    return {name, std::move(input), spec};
}

void refuse_unusual_layout(const ExrFile& exr) {
    const OIIO::ImageSpec& spec = exr.spec;
    refuse_bad_size({spec.width, spec.height}, exr.name);
    if (spec.deep) throw FrameError(exr.name + ": deep samples; expected one flat value per pixel");
    const bool whole = spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
                       spec.height == spec.full_height;
    if (!whole) throw FrameError(exr.name + ": the data window is not the display window; write every pixel");
}

std::string joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
}

int channel_named(const ExrFile& exr, const std::string& channel) {
    const std::vector<std::string>& names = exr.spec.channelnames;
    const auto found = std::ranges::find(names, channel);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    throw FrameError(exr.name + ": channel '" + channel + "' is missing; the file holds " + joined(names));
}

/// A channel by name and the type that the contract gives it.
struct Channel {
    std::string name;
    OIIO::TypeDesc type;
};

/// Reads one channel in its own type (TypeUnknown = native), so that no conversion touches the bits.
void read_channel(const ExrFile& exr, const Channel& channel, void* values) {
    const int index = channel_named(exr, channel.name);
    const OIIO::TypeDesc type = exr.spec.channelformat(index);
    if (type != channel.type) {
        throw FrameError(exr.name + ": channel '" + channel.name + "' is of type " + type.c_str() +
                         "; expected " + channel.type.c_str());
    }
    if (!exr.input->read_image(0, 0, index, index + 1, OIIO::TypeUnknown, values)) {
        throw FrameError(exr.name + ": channel '" + channel.name +
                         "' cannot be read: " + exr.input->geterror());
    }
}

}  // namespace

void write_exr(const std::filesystem::path& file, const Frame& frame) {
    static_assert(sizeof(PrimitiveId) == 4 && sizeof(float) == 4);
    const ExrChannel channels[] = {{"Z", ExrType::float32, frame.camera_depth.pixels().data()},
                                   {"id", ExrType::uint32, frame.primitive.pixels().data()}};
    write_whole_file(file, encode_exr(frame.size(), channels, file.string()));
}

void write_exr(const std::filesystem::path& file, const Picture& picture) {
    refuse_bad_size(picture.size(), file.string());
    const LinearRgb* first = picture.pixels().data();
    const ExrChannel channels[] = {{"B", ExrType::float32, &first->b, sizeof *first},
                                   {"G", ExrType::float32, &first->g, sizeof *first},
                                   {"R", ExrType::float32, &first->r, sizeof *first}};
    write_whole_file(file, encode_exr(picture.size(), channels, file.string()));
}

Frame read_exr(const std::filesystem::path& file) {
    const ExrFile exr = open_exr(file);
    refuse_unusual_layout(exr);
    Frame frame({exr.spec.width, exr.spec.height});
    read_channel(exr, {"id", OIIO::TypeUInt32}, frame.primitive.pixels().data());
    read_channel(exr, {"Z", OIIO::TypeFloat}, frame.camera_depth.pixels().data());
    return frame;
}

Picture read_picture_exr(const std::filesystem::path& file) {
    const ExrFile exr = open_exr(file);
    refuse_unusual_layout(exr);
    Picture picture({exr.spec.width, exr.spec.height});
    std::vector<float> values(picture.size().pixel_count());
    for (const auto& [name, channel] :
         {std::pair{"R", &LinearRgb::r}, {"G", &LinearRgb::g}, {"B", &LinearRgb::b}}) {
        read_channel(exr, {name, OIIO::TypeFloat}, values.data());
        for (std::size_t i = 0; i < values.size(); ++i) picture.pixels()[i].*channel = values[i];
    }
    return picture;
}

}  // namespace zproof
