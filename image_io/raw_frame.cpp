#include "image_io/raw_frame.h"

#include <algorithm>
#include <array>
#include <utility>

#include "frame/frame_error.h"
#include "frame/number_text.h"
#include "image_io/attribute_channels.h"
#include "image_io/frame_files.h"
#include "image_io/id_decoder.h"
#include "image_io/image_file.h"
#include "image_io/samples.h"

namespace zproof {
namespace {

using namespace image_io;
namespace fs = std::filesystem;

/// Types that a channel may have.
struct SampleTypes {
    bool (*include)(Sample);
    const char* words;
};

bool is_whole(Sample sample) {
    return is_unsigned(sample) || sample == Sample::int32 || sample == Sample::int64;
}
bool is_floating(Sample sample) { return is_real(sample) || sample == Sample::float64; }
/// A double holds each of its values.
bool fits_double(Sample sample) {
    return is_floating(sample) || (is_whole(sample) && sample != Sample::int64);
}

constexpr SampleTypes whole_types{is_whole, "an integer"};
constexpr SampleTypes float_types{is_floating, "half, float or double"};
constexpr SampleTypes byte_types{[](Sample sample) { return sample == Sample::uint8; }, "uint8"};
constexpr SampleTypes depth_types{fits_double, "half, float, double or an integer of up to 32 bits"};
constexpr SampleTypes whole_depth_types{[](Sample sample) { return is_whole(sample) && fits_double(sample); },
                                        "an integer of up to 32 bits (depth_coding=float: any)"};

const SampleTypes& depth_types_of(const Convention& convention) {
    return convention.depth_is_whole ? whole_depth_types : depth_types;
}

const SampleTypes& types_of(IdCoding coding) {
    if (coding == IdCoding::integer) return whole_types;
    return coding == IdCoding::real ? float_types : byte_types;
}

/// Every channel that is called so: "Z" in any part, "left:Z" in the part of that name.
std::vector<ChannelPlace> channels_named(const ImageFile& file, const std::string& name) {
    std::vector<ChannelPlace> places;
    for (std::size_t p = 0; p < file.parts().size(); ++p) {
        const Part& part = file.parts()[p];
        for (std::size_t c = 0; c < part.channels.size(); ++c)
            if (name == part.channels[c].name || name == part.name + ":" + part.channels[c].name)
                places.push_back({int(p), int(c)});
    }
    return places;
}

/// Formats other than OpenEXR have no names for channels: the first image of one channel of these types.
std::optional<ChannelPlace> lone_channel(const ImageFile& file, const SampleTypes& types) {
    if (file.format() == Format::exr) return std::nullopt;
    for (std::size_t p = 0; p < file.parts().size(); ++p) {
        const std::vector<Channel>& channels = file.parts()[p].channels;
        if (channels.size() == 1 && types.include(channels[0].sample)) return ChannelPlace{int(p), 0};
    }
    return std::nullopt;
}

std::optional<ChannelPlace> find_channel(const ImageFile& file, const std::string& name,
                                         const SampleTypes& types) {
    const std::vector<ChannelPlace> named = channels_named(file, name);
    if (named.size() > 1)
        throw FrameError(file.name() + ": channel '" + name + "' stands in several parts; the file holds " +
                         file.what_it_holds() + "; name one with its part, PART:CHANNEL, in --channels");
    if (named.empty()) return lone_channel(file, types);
    if (const Sample found = file.channel(named[0]).sample; !types.include(found))
        throw FrameError(file.name() + ": channel '" + name + "' is of type " + name_of(found) +
                         "; expected " + types.words + " (docs/conventions.md)");
    return named[0];
}

std::string missing_channel(const ImageFile& file, const std::string& channel) {
    return file.name() + ": channel '" + channel + "' is missing; the file holds " + file.what_it_holds() +
           "; --channels id=NAME,depth=NAME says which is which";
}

/// The names of the three bytes of a code, lowest first.
std::array<std::string, 3> code_names(const ImageFile& file, const Convention& convention) {
    const std::string layer = convention.id_channel + ".";
    const std::string prefix = channels_named(file, layer + "R").empty() ? "" : layer;
    std::array<std::string, 3> names{prefix + "R", prefix + "G", prefix + "B"};
    if (file.format() == Format::npy) names = {"0", "1", "2"};
    if (convention.id_coding == IdCoding::bgr) std::swap(names[0], names[2]);
    return names;
}

/// The channels of the ids: one, or three for codes.
std::vector<std::string> id_names(const ImageFile& file, const Convention& convention) {
    if (convention.id_coding != IdCoding::rgb && convention.id_coding != IdCoding::bgr)
        return {convention.id_channel};
    const std::array<std::string, 3> names = code_names(file, convention);
    return {names.begin(), names.end()};
}

/// action(column, number) of every sample of a row.
template <class Action>
void for_each_number(const SampleRow& row, const Action& action) {
    const auto each = [&]<class Stored>(Stored sample) {
        for (int i = 0; i < row.count; ++i) {
            std::memcpy(&sample, row.first + std::size_t(i) * row.stride, sizeof sample);
            action(row.x + i, sample);
        }
    };
    switch (row.sample) {
        case Sample::uint8:
            return each(std::uint8_t{});
        case Sample::uint16:
            return each(std::uint16_t{});
        case Sample::uint32:
            return each(std::uint32_t{});
        case Sample::int32:
            return each(std::int32_t{});
        case Sample::int64:
            return each(std::int64_t{});
        case Sample::float32:
            return each(float{});
        case Sample::float64:
            return each(double{});
        case Sample::half:
            for (int i = 0; i < row.count; ++i) {
                std::uint16_t half = 0;
                std::memcpy(&half, row.first + std::size_t(i) * row.stride, sizeof half);
                action(row.x + i, float_of_half(half));
            }
            return;
        case Sample::other:
            break;
    }
    throw std::logic_error{"samples of a type that was to be refused"};
}

/// The headers of a frame, checked; its samples are still to be read.
class RawPlanes {
  public:
    RawPlanes(const fs::path& file, const Convention& convention)
        : RawPlanes(frame_files(file), convention) {}

    Resolution size() const { return size_; }

    RawFrame frame() const {
        RawFrame frame{.primitive = std::nullopt,
                       .why_no_ids = why_no_ids_,
                       .stored_depth = Plane<double>(size_, std::numeric_limits<double>::infinity()),
                       .attributes = read_attributes(depth_file(), depth_place_, size_)};
        if (id_places_.size() == 1) frame.primitive = ids();
        if (id_places_.size() == 3) frame.primitive = codes();
        const WantedChannel wanted{depth_place_, [&](const SampleRow& row) {
                                       for_each_number(row, [&](int x, auto number) {
                                           frame.stored_depth.at(x, row.y) = double(number);
                                       });
                                   }};
        depth_file().read({&wanted, 1});
        if (convention_.rows == RowOrder::bottom_first) turn_over(frame);
        return frame;
    }

  private:
    RawPlanes(const FrameFiles& files, const Convention& convention)
        : convention_(convention), id_file_(files.ids, "a frame") {
        if (files.depths != files.ids) second_.emplace(files.depths, "the depths of a frame");
        find_ids();
        find_depths();
        size_ = depth_file().size_of(depth_place_.part);
        depth_file().refuse_scaled_samples(depth_place_.part);
        for (const ChannelPlace& place : id_places_) {
            id_file_.refuse_scaled_samples(place.part);
            if (const Resolution other = id_file_.size_of(place.part); other != size_)
                throw FrameError(depth_file().name() + ": depths of " + size_text(size_.width, size_.height) +
                                 " pixels; the ids have " + size_text(other.width, other.height));
        }
    }

    void find_ids() {
        for (const std::string& name : id_names(id_file_, convention_)) {
            const auto place = find_channel(id_file_, name, types_of(convention_.id_coding));
            if (!place) {
                why_no_ids_ = missing_channel(id_file_, name);
                id_places_.clear();
                return;
            }
            id_places_.push_back(*place);
        }
    }

    void find_depths() {
        const ImageFile& file = depth_file();
        auto place = find_channel(file, convention_.depth_channel, floats_or_any(file));
        if (!place && second_) place = lone_channel(file, depth_types_of(convention_));
        if (!place) throw FrameError(missing_channel(file, convention_.depth_channel));
        depth_place_ = *place;
    }

    /// A named channel may be of any type that a depth has; a lone one beside ids is known by being a float.
    const SampleTypes& floats_or_any(const ImageFile& file) const {
        return channels_named(file, convention_.depth_channel).empty() ? float_types
                                                                       : depth_types_of(convention_);
    }

    const ImageFile& depth_file() const { return second_ ? *second_ : id_file_; }

    IdDecoder decoder() const {
        const Channel& channel = id_file_.channel(id_places_[0]);
        return {convention_, channel.sample, id_file_.name() + ": channel '" + channel.name + "'"};
    }

    Plane<PrimitiveId> ids() const {
        Plane<PrimitiveId> ids(size_, PrimitiveId::none);
        const IdDecoder decode = decoder();
        const WantedChannel wanted{
            id_places_[0], [&](const SampleRow& row) {
                for_each_number(row, [&]<class Number>(int x, Number number) {
                    if constexpr (std::is_floating_point_v<Number>)
                        ids.at(x, row.y) = decode.id_of_real(double(number), {x, row.y});
                    else
                        ids.at(x, row.y) = decode.id_of(std::int64_t{number}, {x, row.y});
                });
            }};
        id_file_.read({&wanted, 1});
        return ids;
    }

    Plane<PrimitiveId> codes() const {
        Plane<std::int64_t> codes(size_, -1);  // without data
        std::vector<WantedChannel> wanted;
        for (int i = 0; i < 3; ++i)
            wanted.push_back({id_places_[std::size_t(i)], [&codes, i](const SampleRow& row) {
                                  for_each_number(row, [&](int x, auto number) {
                                      std::int64_t& code = codes.at(x, row.y);
                                      code = std::max<std::int64_t>(code, 0) | std::int64_t(number) << 8 * i;
                                  });
                              }});
        id_file_.read(wanted);
        Plane<PrimitiveId> ids(size_, PrimitiveId::none);
        const IdDecoder decode = decoder();
        for (int y = 0; y < size_.height; ++y)
            for (int x = 0; x < size_.width; ++x)
                if (codes.at(x, y) >= 0) ids.at(x, y) = decode.id_of(codes.at(x, y), {x, y});
        return ids;
    }

    void turn_over(RawFrame& frame) const {
        for (int y = 0; y < size_.height / 2; ++y) {
            const int other = size_.height - 1 - y;
            std::ranges::swap_ranges(frame.stored_depth.row(y), frame.stored_depth.row(other));
            if (frame.primitive)
                std::ranges::swap_ranges(frame.primitive->row(y), frame.primitive->row(other));
            for (Plane<float>& plane : frame.attributes.planes)
                if (plane.size() == size_) std::ranges::swap_ranges(plane.row(y), plane.row(other));
        }
    }

    const Convention& convention_;
    ImageFile id_file_;  ///< of ids, and of depths where there is no second
    std::optional<ImageFile> second_;
    std::vector<ChannelPlace> id_places_;
    std::string why_no_ids_;
    ChannelPlace depth_place_;
    Resolution size_;
};

}  // namespace

RawFrame read_raw_frame(const fs::path& file, const Convention& convention) {
    return RawPlanes(file, convention).frame();
}

Resolution raw_frame_size(const fs::path& file, const Convention& convention) {
    return RawPlanes(file, convention).size();
}

std::vector<std::string> depth_file_channels(const fs::path& file) {
    const ImageFile opened(frame_files(file).depths, "a frame");
    std::vector<std::string> names;
    for (const Part& part : opened.parts())
        for (const Channel& channel : part.channels) names.push_back(channel.name);
    return names;
}

}  // namespace zproof
