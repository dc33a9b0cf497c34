// Reads and writes files by OpenImageIO's ImageInput and ImageOutput: samples keep their own types.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <mutex>
#include <stdexcept>

#include "image_io/module/textures.h"
#include "image_io/module_table.h"

namespace zproof::image_io {

/// An open file, and the memory that it is read from where it lies there.
class OpenFile {
  public:
    std::unique_ptr<OIIO::Filesystem::IOMemReader> memory;  ///< outlives the reader
    std::unique_ptr<OIIO::ImageInput> input;
    int mip_level = 0;
};

namespace {

const char* plugin_of(Format format) {
    switch (format) {
        case Format::exr:
            return "openexr";
        case Format::tiff:
            return "tiff";
        case Format::png:
            return "png";
        case Format::jpeg:
            return "jpeg";
        case Format::dds:
            return "dds";
        default:
            return "pnm";
    }
}

/// OpenImageIO's complaint on one line.
[[noreturn]] void refuse(const std::string& complaint) {
    std::string words = complaint.empty() ? "OpenImageIO gives no reason" : complaint;
    while (!words.empty() && words.back() == '\n') words.pop_back();
    for (char& c : words)
        if (c == '\n') c = ' ';
    throw std::runtime_error(words);
}

/// Files are read and written on the calling thread: zproof's own tasks work side by side.
void work_on_callers_thread() {
    static std::once_flag once;
    std::call_once(once, [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
    });
}

Sample sample_of(OIIO::TypeDesc type) {
    if (type == OIIO::TypeUInt8) return Sample::uint8;
    if (type == OIIO::TypeUInt16) return Sample::uint16;
    if (type == OIIO::TypeUInt32) return Sample::uint32;
    if (type == OIIO::TypeHalf) return Sample::half;
    if (type == OIIO::TypeInt32) return Sample::int32;
    if (type == OIIO::TypeDesc::DOUBLE) return Sample::float64;
    return type == OIIO::TypeFloat ? Sample::float32 : Sample::other;
}

OIIO::TypeDesc type_of(Sample sample) {
    switch (sample) {
        case Sample::uint8:
            return OIIO::TypeUInt8;
        case Sample::uint16:
            return OIIO::TypeUInt16;
        case Sample::uint32:
            return OIIO::TypeUInt32;
        case Sample::half:
            return OIIO::TypeHalf;
        default:
            return OIIO::TypeFloat;
    }
}

OpenFile* open(const Source& source) {
    work_on_callers_thread();
    auto file = std::make_unique<OpenFile>();
    file->mip_level = source.mip_level;
    file->input = OIIO::ImageInput::create(plugin_of(source.format));
    if (!file->input) refuse(OIIO::geterror());
    OIIO::ImageSpec config, header;
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (!source.bytes.empty()) {
        file->memory =
            std::make_unique<OIIO::Filesystem::IOMemReader>(source.bytes.data(), source.bytes.size());
        if (!file->input->set_ioproxy(file->memory.get())) refuse(file->input->geterror());
    }
    if (!file->input->open(source.path, header, config)) refuse(file->input->geterror());
    if (const int orientation = header.get_int_attribute("Orientation", 1);
        source.format == Format::tiff && orientation != 1)
        refuse("its orientation is " + std::to_string(orientation) + "; expected 1, the top row first");
    return file.release();
}

void close(OpenFile* file) { delete file; }

/// Of TIFF: how many bits a whole number has, where they are not those of its type; else 0.
int scaled_bits_of(const OIIO::ImageSpec& spec) {
    const int bits = spec.get_int_attribute("oiio:BitsPerSample");
    return spec.format.is_floating_point() || bits == 8 * int(spec.format.size()) ? 0 : bits;
}

Part part_of(const OIIO::ImageSpec& spec) {
    Part part{.name = spec.get_string_attribute("oiio:subimagename"),
              .data = {spec.x, spec.y, spec.width, spec.height},
              .display = {spec.full_x, spec.full_y, spec.full_width, spec.full_height},
              .samples = spec.deep ? Samples::deep : Samples::flat,
              .rows_at_once = spec.tile_height > 0 ? spec.tile_height : 1,
              .channels = {},
              .scaled_bits = scaled_bits_of(spec)};
    for (int c = 0; c < spec.nchannels; ++c)
        part.channels.push_back({spec.channel_name(c), sample_of(spec.channelformat(c))});
    return part;
}

int mip_levels_of(OIIO::ImageInput& input, int part) {
    int count = 1;
    while (count < most_mip_levels && input.seek_subimage(part, count)) ++count;
    return count;
}

std::vector<Part> parts(OpenFile& file) {
    std::vector<Part> all;
    for (int i = 0; file.input->seek_subimage(i, file.mip_level); ++i) {
        all.push_back(part_of(file.input->spec()));
        all.back().mip_levels = mip_levels_of(*file.input, i);
    }
    file.input->geterror();  // that there is no further image is no fault
    return all;
}

void read(OpenFile& file, const Block& block, void* to) {
    OIIO::ImageInput& input = *file.input;
    const OIIO::ImageSpec spec = input.spec_dimensions(block.part, file.mip_level);
    const int top = spec.y + block.first_row, end = top + block.row_count;
    const int first = block.first_channel, last = first + block.channel_count;
    const bool done = spec.tile_width > 0
                          ? input.read_tiles(block.part, file.mip_level, spec.x, spec.x + spec.width, top,
                                             end, spec.z, spec.z + 1, first, last, OIIO::TypeUnknown, to)
                          : input.read_scanlines(block.part, file.mip_level, top, end, spec.z, first, last,
                                                 OIIO::TypeUnknown, to);
    // Some readers go on after an error that their own library reported.
    if (!done || input.has_error()) refuse(input.geterror());
}

constexpr int jpeg_quality = 75;  // of 100: a quarter of the bytes of a PNG

OIIO::ImageSpec spec_of(const Raster& raster) {
    OIIO::ImageSpec spec(raster.width, raster.height, int(raster.channels.size()),
                         type_of(raster.channels.front().sample));
    for (std::size_t c = 0; c < raster.channels.size(); ++c) {
        spec.channelnames[c] = raster.channels[c].name;
        spec.channelformats.push_back(type_of(raster.channels[c].sample));
    }
    if (raster.format == Format::jpeg) {
        spec.channelformats.clear();
        spec.attribute("compression", "jpeg:" + std::to_string(jpeg_quality));
    } else if (raster.format == Format::png) {
        spec.channelformats.clear();
        spec.attribute("oiio:ColorSpace", raster.light == Light::srgb ? "sRGB" : "Linear");
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.attribute("png:compressionLevel", 1);
    } else {
        spec.attribute("compression", "zip:1");
        spec.attribute("DateTime", "");  // else the time of day would be part of the file
        for (const auto& [name, value] : raster.facts) spec.attribute(name, value);
    }
    return spec;
}

std::vector<unsigned char> encode(const Raster& raster) {
    work_on_callers_thread();
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(plugin_of(raster.format));
    if (!output) refuse(OIIO::geterror());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = std::string("memory.") + plugin_of(raster.format);
    if (!output->set_ioproxy(&memory) || !output->open(name, spec_of(raster)) ||
        !output->write_image(OIIO::TypeUnknown, raster.pixels) || !output->close())
        refuse(output->geterror());
    return bytes;
}

constexpr ModuleTable table{.open = open,
                            .close = close,
                            .parts = parts,
                            .read = read,
                            .encode = encode,
                            .open_textures = open_textures,
                            .close_textures = close_textures,
                            .add_texture = add_texture,
                            .look_up = look_up};

}  // namespace
}  // namespace zproof::image_io

extern "C" [[gnu::visibility("default")]] const zproof::image_io::ModuleTable* zproof_image_io() {
    return &zproof::image_io::table;
}
