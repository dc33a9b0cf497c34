// Frames and pictures as files of planes.
#include <array>
#include <cassert>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "frame/frame_error.h"
#include "frame/number_text.h"
#include "frame/whole_file.h"
#include "image_io/attribute_channels.h"
#include "image_io/frame_files.h"
#include "image_io/image_file.h"
#include "image_io/image_io.h"
#include "image_io/module.h"
#include "image_io/samples.h"

namespace zproof {
namespace {

using namespace image_io;
namespace fs = std::filesystem;

/// One of the two planes of a frame.
struct Layer {
    const char* channel;
    bool (*has_type)(Sample);
    const char* types;
};
constexpr Layer id_layer{"id", is_unsigned, "uint"}, depth_layer{"Z", is_real, "float or half"};

std::optional<ChannelPlace> channel_named(const ImageFile& file, const std::string& name) {
    std::optional<ChannelPlace> found;
    for (std::size_t p = 0; p < file.parts().size(); ++p)
        for (std::size_t c = 0; c < file.parts()[p].channels.size(); ++c) {
            if (file.parts()[p].channels[c].name != name) continue;
            if (found)
                throw FrameError(file.name() + ": channel '" + name +
                                 "' stands in several parts; the file holds " + file.what_it_holds() +
                                 "; expected it once");
            found = ChannelPlace{int(p), int(c)};
        }
    return found;
}

/// TIFF, PNG and PFM have no names for channels: an image of one channel is known by its type.
std::optional<ChannelPlace> only_channel(const ImageFile& file, const Layer& layer) {
    if (file.format() == Format::exr) return std::nullopt;
    for (std::size_t p = 0; p < file.parts().size(); ++p) {
        const std::vector<Channel>& channels = file.parts()[p].channels;
        if (channels.size() == 1 && layer.has_type(channels[0].sample)) return ChannelPlace{int(p), 0};
    }
    return std::nullopt;
}

[[noreturn]] void refuse_missing(const ImageFile& file, const std::string& channel) {
    throw FrameError(
        file.name() + ": channel '" + channel + "' is missing; the file holds " + file.what_it_holds() +
        (file.format() == Format::exr
             ? ""
             : "; expected an image of one channel: unsigned integers for ids, floats for depths "
               "(integers where --convention depth_scale=0.001 says what 1 is); two files are named as "
               "IDS+DEPTHS"));
}

ChannelPlace require(const ImageFile& file, const Layer& layer) {
    const std::optional<ChannelPlace> named = channel_named(file, layer.channel);
    const std::optional<ChannelPlace> place = named ? named : only_channel(file, layer);
    if (!place) refuse_missing(file, layer.channel);
    const Sample found = file.channel(*place).sample;
    if (!layer.has_type(found))
        throw FrameError(file.name() + ": channel '" + layer.channel + "' is of type " + name_of(found) +
                         "; expected " + layer.types);
    file.refuse_scaled_samples(place->part);
    return *place;
}

/// The headers of a frame, checked; its samples are still to be read.
class StoredPlanes {
  public:
    StoredPlanes(const fs::path& file, IdChannel ids) : StoredPlanes(frame_files(file), ids) {}

    Resolution size() const { return size_; }
    Frame frame() const {
        Frame frame(size_);
        const WantedChannel ids{id_place_.value_or(ChannelPlace{}), [&](const SampleRow& row) {
                                    spread_ids(row, frame.primitive.row(row.y).subspan(std::size_t(row.x)));
                                }};
        const WantedChannel depths{
            depth_place_, [&](const SampleRow& row) {
                spread_reals(row, frame.camera_depth.row(row.y).subspan(std::size_t(row.x)),
                             [](float& to, const float& value) { std::memcpy(&to, &value, sizeof to); });
            }};
        if (id_file_) id_file_->read({&ids, 1});
        if (id_place_ && !id_file_)
            depth_file_.read(std::array{ids, depths});
        else
            depth_file_.read({&depths, 1});
        frame.attributes = read_attributes(depth_file_, depth_place_, size_);
        return frame;
    }

  private:
    StoredPlanes(const FrameFiles& files, IdChannel ids)
        : depth_file_(files.depths,
                      files.ids == files.depths ? "an OpenEXR frame" : "the depths of a frame") {
        if (ids == IdChannel::present) find_ids(files);
        depth_place_ = require(depth_file_, depth_layer);
        size_ = depth_file_.size_of(depth_place_.part);
        if (id_place_) require_size_of_ids();
    }

    void find_ids(const FrameFiles& files) {
        if (files.ids != files.depths) id_file_.emplace(files.ids, "an OpenEXR frame");
        id_place_ = require(id_file_ ? *id_file_ : depth_file_, id_layer);
    }

    void require_size_of_ids() const {
        const Resolution of_ids = (id_file_ ? *id_file_ : depth_file_).size_of(id_place_->part);
        if (of_ids == size_) return;
        throw FrameError(depth_file_.name() + ": depths of " + size_text(size_.width, size_.height) +
                         " pixels; the ids have " + size_text(of_ids.width, of_ids.height));
    }

    ImageFile depth_file_;
    std::optional<ImageFile> id_file_;  ///< where it is another
    std::optional<ChannelPlace> id_place_;
    ChannelPlace depth_place_;
    Resolution size_;
};

/// An open file with the channels of a picture.
class PictureFile {
  public:
    explicit PictureFile(const fs::path& file, int mip_level = 0)
        : file_(file, "an OpenEXR picture", mip_level) {
        for (const char* name : {"R", "G", "B"})
            places_.push_back(require(file_, {name, is_real, "float or half"}));
        size_ = file_.size_of(places_[0].part);
        for (const ChannelPlace& place : places_)
            if (file_.size_of(place.part) != size_)
                throw FrameError(file_.name() + ": R, G and B have unlike sizes");
    }

    Resolution size() const { return size_; }

    Picture picture() const {
        constexpr float LinearRgb::*parts[] = {&LinearRgb::r, &LinearRgb::g, &LinearRgb::b};
        Picture picture(size_);
        std::vector<WantedChannel> wanted;
        for (std::size_t c = 0; c < places_.size(); ++c)
            wanted.push_back({places_[c], [&picture, part = parts[c]](const SampleRow& row) {
                                  spread_reals(row, picture.row(row.y).subspan(std::size_t(row.x)),
                                               [part](LinearRgb& to, const float& value) {
                                                   std::memcpy(&(to.*part), &value, sizeof value);
                                               });
                              }});
        file_.read(wanted);
        return picture;
    }

  private:
    ImageFile file_;
    std::vector<ChannelPlace> places_;
    Resolution size_;
};

void write_raster(const fs::path& file, const Raster& raster) {
    refuse_bad_size({raster.width, raster.height}, file.string());
    std::vector<unsigned char> bytes;
    try {
        bytes = module().encode(raster);
    } catch (const FrameError&) {
        throw;
    } catch (const std::runtime_error& e) {
        throw FrameError(file.string() + ": cannot be written: " + e.what());
    }
    write_whole_file(file, std::as_bytes(std::span{bytes}));
}

}  // namespace

Frame read_frame(const fs::path& file, IdChannel ids) { return StoredPlanes(file, ids).frame(); }

Resolution frame_size(const fs::path& file, IdChannel ids) { return StoredPlanes(file, ids).size(); }

void write_frame(const fs::path& file, const Frame& frame) {
    std::vector<Channel> channels{{"id", Sample::uint32}, {"Z", Sample::float32}};
    std::vector<const float*> reals{frame.camera_depth.pixels().data()};
    for (std::size_t c = 0; c < attribute_channels.size(); ++c) {
        if (!frame.attributes.has(c)) continue;
        channels.push_back({std::string(attribute_channels[c].name), Sample::float32});
        reals.push_back(frame.attributes.planes[c].pixels().data());
    }
    const std::size_t count = frame.size().pixel_count();
    std::vector<std::uint32_t> samples;  // bit for bit
    samples.reserve(count * channels.size());
    for (std::size_t i = 0; i < count; ++i) {
        samples.push_back(std::uint32_t(frame.primitive.pixels()[i]));
        for (const float* plane : reals) std::memcpy(&samples.emplace_back(), plane + i, sizeof(float));
    }
    write_raster(file, {.format = Format::exr,
                        .width = frame.size().width,
                        .height = frame.size().height,
                        .channels = std::move(channels),
                        .pixels = samples.data()});
}

Picture read_picture(const fs::path& file, int mip_level) { return PictureFile(file, mip_level).picture(); }

Resolution picture_size(const fs::path& file) { return PictureFile(file).size(); }

void write_picture(const fs::path& file, const Picture& picture, const FileFacts& facts) {
    static_assert(sizeof(LinearRgb) == 3 * sizeof(float));
    write_raster(file, {.format = Format::exr,
                        .width = picture.size().width,
                        .height = picture.size().height,
                        .channels = {{"R", Sample::float32}, {"G", Sample::float32}, {"B", Sample::float32}},
                        .pixels = picture.pixels().data(),
                        .facts = facts});
}

void write_planes(const fs::path& file, std::span<const NamedPlane> planes, const FileFacts& facts) {
    const auto size_of = [](const NamedPlane& plane) {
        return std::visit([](const auto* values) { return values->size(); }, plane.values);
    };
    const Resolution size = size_of(planes.front());
    std::vector<std::uint32_t> samples(size.pixel_count() * planes.size());  // bit for bit
    std::vector<Channel> channels;
    for (std::size_t c = 0; c < planes.size(); ++c) {
        assert(size_of(planes[c]) == size);
        const bool is_real = std::holds_alternative<const Plane<float>*>(planes[c].values);
        channels.push_back({planes[c].name, is_real ? Sample::float32 : Sample::uint32});
        std::visit(
            [&](const auto* values) {
                for (std::size_t i = 0; i < size.pixel_count(); ++i)
                    std::memcpy(&samples[i * planes.size() + c], &values->pixels()[i], sizeof(std::uint32_t));
            },
            planes[c].values);
    }
    write_raster(file, {.format = Format::exr,
                        .width = size.width,
                        .height = size.height,
                        .channels = std::move(channels),
                        .pixels = samples.data(),
                        .facts = facts});
}

}  // namespace zproof
