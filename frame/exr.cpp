#include "frame/exr.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "frame/encode.h"
#include "frame/frame_error.h"
#include "frame/whole_file.h"

namespace zproof {
namespace {

/// One pixel as it is handed to OpenEXR: the channels' native types, interleaved in the order of the spec.
struct NativePixel {
    PrimitiveId id;
    float z;
};
static_assert(sizeof(NativePixel) == 8 && sizeof(PrimitiveId) == 4);

/// OpenImageIO stamps a file with the hour, unless it has a stamp: the same frame shall be the same file.
void write_no_hour(OIIO::ImageSpec& spec) { spec.attribute("DateTime", "1970:01:01 00:00:00"); }

OIIO::ImageSpec frame_spec(Resolution size) {
    OIIO::ImageSpec spec(size.width, size.height, 2, OIIO::TypeFloat);
    spec.channelnames = {"id", "Z"};
    spec.channelformats = {OIIO::TypeUInt32, OIIO::TypeFloat};
    spec.attribute("compression", "zip:1");
    write_no_hour(spec);
    return spec;
}

std::vector<NativePixel> interleave(const Frame& frame) {
    std::vector<NativePixel> pixels(frame.size().pixel_count());
    std::ranges::transform(frame.primitive.pixels(), frame.camera_depth.pixels(), pixels.begin(),
                           [](PrimitiveId id, float z) {
                               return NativePixel{id, z};
                           });
    return pixels;
}

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
    refuse_bad_size(frame.size(), file.string());
    const Encoding encoding{"openexr", frame_spec(frame.size())};
    write_whole_file(file, encode(encoding, interleave(frame).data(), file.string()));
}

void write_exr(const std::filesystem::path& file, const Picture& picture) {
    static_assert(sizeof(LinearRgb) == 3 * sizeof(float));
    refuse_bad_size(picture.size(), file.string());
    OIIO::ImageSpec spec(picture.size().width, picture.size().height, 3, OIIO::TypeFloat);
    spec.attribute("compression", "zip:1");
    write_no_hour(spec);
    write_whole_file(file, encode({"openexr", spec}, picture.pixels().data(), file.string()));
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
